//! Numbers of vertices, triangles and border half-edges: 32 bits each, and a type for each, so that the compiler keeps
//! them apart. [`narrow`] alone makes a count or position 32 bits wide; the size of the input was checked before.

/// A vertex: its rank in the sweep order, or an artificial point above. In a result, a position in its `vertices`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(crate) struct VertexId(u32);

/// A triangle: its place in the mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(crate) struct TriangleId(u32);

/// A border half-edge: a segment of the advancing front, or a side of an empty polygon.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(crate) struct BorderId(u32);

#[inline(always)]
pub(crate) fn narrow(n: usize) -> u32 {
    u32::try_from(n).expect("the input's size was checked")
}

macro_rules! id {
    ($type:ty) => {
        impl $type {
            #[inline(always)]
            pub(crate) const fn new(number: u32) -> Self {
                Self(number)
            }

            #[inline(always)]
            pub(crate) fn at(place: usize) -> Self {
                Self(narrow(place))
            }

            #[inline(always)]
            pub(crate) const fn number(self) -> u32 {
                self.0
            }

            #[inline(always)]
            pub(crate) const fn index(self) -> usize {
                self.0 as usize
            }
        }
    };
}

id!(VertexId);
id!(TriangleId);
id!(BorderId);

impl BorderId {
    /// The segment of the front that starts at `v`: segments bear the number of their left end.
    #[inline(always)]
    pub(crate) const fn segment(v: VertexId) -> Self {
        BorderId(v.0)
    }

    #[inline(always)]
    pub(crate) const fn left_end(self) -> VertexId {
        VertexId(self.0)
    }
}
