// The answer to the request for a picture: a line of JSON, and numbers after it.

class Answer {
  constructor(bytes) {
    const end = bytes.indexOf(10);
    Object.assign(this, { summary: JSON.parse(new TextDecoder().decode(bytes.subarray(0, end))) });
    const { vertices, edges, triangles, inner, border, crossings } = this.summary;
    let at = end + 1;
    const numbers = (Kind, count) => {
      const length = count * Kind.BYTES_PER_ELEMENT;
      at += length;
      return new Kind(bytes.slice(at - length, at).buffer);
    };
    this.vertices = numbers(Float64Array, 2 * vertices);
    this.edges = numbers(Uint32Array, 2 * edges);
    this.triangles = numbers(Uint32Array, 3 * triangles);
    this.inner = numbers(Uint32Array, 2 * inner);
    this.border = numbers(Uint32Array, 2 * border);
    this.crossings = numbers(Float64Array, 2 * crossings);
    this.crossing = new Set(numbers(Uint32Array, 2 * crossings));
  }

  /** The points of the input as pairs. */
  points() {
    return pairs(this.vertices.subarray(0, 2 * this.summary.points));
  }
}

/** Numbers two by two. */
function pairs(numbers) {
  return Array.from({ length: numbers.length / 2 }, (_, at) => [numbers[2 * at], numbers[2 * at + 1]]);
}
