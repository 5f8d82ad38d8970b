//! `.vtu` in forms that the crate does not write.

use super::meant::Meant;
use super::numbers::{Form, Kind, Order};
use super::vtk::Cells;

/// How the arrays of a file stand in it, and the file so far.
struct File {
    is_text: bool,
    is_appended: bool,
    is_base64: bool,
    is_zlib: bool,
    has_wide_headers: bool,
    /// Whether headers are written in base 64 of their own.
    has_headers_apart: bool,
    /// Bytes of a block that is packed.
    block: usize,
    order: Order,
    elements: String,
    appended: Vec<u8>,
}

/// VTK's XML format: arrays as text, in base 64 or appended; packed by zlib or not.
pub(super) fn write(meant: &Meant, style: u8, number: u8, packing: u8) -> Vec<u8> {
    let bit = |at: u8| packing >> at & 1 != 0;
    let is_text = packing & 3 == 0;
    let mut file = File {
        is_text,
        is_appended: bit(1),
        is_base64: bit(0),
        is_zlib: bit(2) && !is_text,
        has_wide_headers: bit(3),
        has_headers_apart: bit(4),
        block: [7, 48, 100, 4096][usize::from(packing >> 5 & 3)],
        order: match (is_text, bit(7)) {
            (true, _) => Order::Text,
            (false, false) => Order::LeastSignificantFirst,
            (false, true) => Order::MostSignificantFirst,
        },
        elements: String::new(),
        appended: Vec::new(),
    };
    let mut places = Vec::new();
    for (v, &[x, y]) in meant.points.iter().enumerate() {
        places.extend([x, y, meant.heights.get(v).copied().unwrap_or(0.0)]);
    }
    let cells = Cells::of(meant, style);
    let numbers = |indices: &[usize]| -> Vec<f64> {
        #[expect(clippy::cast_precision_loss, reason = "there are few vertices")]
        indices.iter().map(|&index| index as f64).collect()
    };
    let corners = numbers(&cells.list.concat());
    let end = |at: usize| cells.list[..=at].concat().len();
    let ends: Vec<usize> = (0..cells.list.len()).map(end).collect();
    file.open("Points");
    file.array("Points", 3, Kind::holding(number, &places), &places);
    file.close("Points");
    file.open("Cells");
    file.array(
        "connectivity",
        1,
        Kind::holding(number >> 3, &corners),
        &corners,
    );
    file.array("types", 1, Kind::U8, &numbers(&cells.types));
    file.array("offsets", 1, Kind::I64, &numbers(&ends));
    file.close("Cells");
    file.finish(meant.points.len(), cells.list.len())
}

impl File {
    fn open(&mut self, name: &str) {
        self.elements += &format!("<{name}>\n");
    }

    fn close(&mut self, name: &str) {
        self.elements += &format!("</{name}>\n");
    }

    fn array(&mut self, name: &str, components: usize, kind: Kind, numbers: &[f64]) {
        let order = self.order;
        let mut bytes = Vec::new();
        numbers
            .iter()
            .for_each(|&x| Form { kind, order }.put(x, &mut bytes));
        let format = match (self.is_text, self.is_appended) {
            (true, _) => "ascii",
            (false, false) => "binary",
            (false, true) => "appended",
        };
        self.elements += &format!(
            "<DataArray type='{}' Name='{name}' NumberOfComponents='{components}' format='{format}' offset='{}'>",
            name_of(kind),
            self.appended.len(),
        );
        if !self.is_text {
            bytes = self.packed(&bytes);
        }
        if self.is_appended && !self.is_text {
            self.appended.append(&mut bytes);
        }
        self.elements += &String::from_utf8(bytes).expect("text or base 64");
        self.elements += "</DataArray>\n";
    }

    /// A header and the bytes, in base 64 unless the file has them as they are.
    fn packed(&self, bytes: &[u8]) -> Vec<u8> {
        let (mut sizes, mut body) = (vec![bytes.len()], bytes.to_vec());
        if self.is_zlib {
            let blocks: Vec<Vec<u8>> = bytes.chunks(self.block).map(stored).collect();
            sizes = vec![blocks.len(), self.block, bytes.len() % self.block];
            sizes.extend(blocks.iter().map(Vec::len));
            body = blocks.concat();
        }
        let mut header = Vec::new();
        for size in sizes {
            let bytes = size.to_be_bytes();
            let mut number = if self.has_wide_headers {
                bytes.to_vec()
            } else {
                bytes[4..].to_vec()
            };
            if self.order == Order::LeastSignificantFirst {
                number.reverse();
            }
            header.append(&mut number);
        }
        match (self.is_base64 || !self.is_appended, self.has_headers_apart) {
            (false, _) => [header, body].concat(),
            (true, true) => [base64(&header), base64(&body)].concat(),
            (true, false) => base64(&[header, body].concat()),
        }
    }

    fn finish(self, points: usize, cells: usize) -> Vec<u8> {
        let order = match self.order {
            Order::MostSignificantFirst => "BigEndian",
            _ => "LittleEndian",
        };
        let header = if self.has_wide_headers {
            "UInt64"
        } else {
            "UInt32"
        };
        let compressor = if self.is_zlib {
            "compressor='vtkZLibDataCompressor'"
        } else {
            ""
        };
        let elements = self.elements;
        let mut file = format!(
            "<VTKFile type='UnstructuredGrid' byte_order='{order}' header_type='{header}' {compressor}>\n\
             <UnstructuredGrid><Piece NumberOfPoints='{points}' NumberOfCells='{cells}'>\n\
             {elements}</Piece></UnstructuredGrid>\n"
        )
        .into_bytes();
        if self.is_appended && !self.is_text {
            let encoding = if self.is_base64 { "base64" } else { "raw" };
            file.extend(format!("<AppendedData encoding='{encoding}'>\n_").into_bytes());
            file.extend(self.appended);
            file.extend(b"\n</AppendedData>\n");
        }
        file.extend(b"</VTKFile>\n");
        file
    }
}

/// Zlib's format, with the bytes as they are: a block that is stored, and Adler's sum of it.
fn stored(bytes: &[u8]) -> Vec<u8> {
    let length = u16::try_from(bytes.len()).expect("a small block");
    let (mut low, mut high) = (1, 0);
    for &byte in bytes {
        low = (low + u32::from(byte)) % 65521;
        high = (high + low) % 65521;
    }
    let head = [
        &[0x78, 0x01, 0x01][..],
        &length.to_le_bytes(),
        &(!length).to_le_bytes(),
    ];
    [&head.concat(), bytes, &(high << 16 | low).to_be_bytes()].concat()
}

fn base64(bytes: &[u8]) -> Vec<u8> {
    const SIGNS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = Vec::new();
    for three in bytes.chunks(3) {
        let byte = |at: usize| three.get(at).copied().map_or(0, usize::from);
        let bits = byte(0) << 16 | byte(1) << 8 | byte(2);
        for at in 0..4 {
            let sign = SIGNS[bits >> (18 - 6 * at) & 63];
            text.push(if at > three.len() { b'=' } else { sign });
        }
    }
    text
}

fn name_of(kind: Kind) -> &'static str {
    match kind {
        Kind::I8 => "Int8",
        Kind::U8 => "UInt8",
        Kind::I16 => "Int16",
        Kind::U16 => "UInt16",
        Kind::I32 => "Int32",
        Kind::U32 => "UInt32",
        Kind::I64 => "Int64",
        Kind::F32 => "Float32",
        Kind::F64 => "Float64",
    }
}
