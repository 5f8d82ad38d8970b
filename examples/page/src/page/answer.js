// The answer to the request for a picture: a line of JSON, and numbers after it.

class Answer {
  constructor(bytes) {
    const end = bytes.indexOf(10);
    Object.assign(this, { summary: JSON.parse(new TextDecoder().decode(bytes.subarray(0, end))) });
    const { vertices, edges, triangles, crossings } = this.summary;
    let at = end + 1;
    const numbers = (Kind, count) => {
      const length = count * Kind.BYTES_PER_ELEMENT;
      at += length;
      return new Kind(bytes.slice(at - length, at).buffer);
    };
    this.vertices = numbers(Float64Array, 2 * vertices);
    this.edges = numbers(Uint32Array, 2 * edges);
    this.triangles = numbers(Uint32Array, 3 * triangles);
    this.crossings = numbers(Float64Array, 2 * crossings);
    this.crossing = new Set(numbers(Uint32Array, 2 * crossings));
    [this.inner, this.border] = this.sides();
  }

  /** The points of the input as pairs. */
  points() {
    return pairs(this.vertices.subarray(0, 2 * this.summary.points));
  }

  /** The sides of two triangles, and those of one, as ends one after the other. */
  sides() {
    const count = this.summary.vertices;
    const keys = new Float64Array(this.triangles.length);
    for (let corner = 0; corner < keys.length; corner++) {
      const next = corner % 3 === 2 ? corner - 2 : corner + 1;
      const [a, b] = [this.triangles[corner], this.triangles[next]];
      keys[corner] = Math.min(a, b) * count + Math.max(a, b);
    }
    keys.sort();
    const [inner, border] = [[], []];
    for (let at = 0; at < keys.length; at++) {
      const isTwice = keys[at] === keys[at + 1];
      (isTwice ? inner : border).push(Math.floor(keys[at] / count), keys[at] % count);
      at += isTwice ? 1 : 0;
    }
    return [inner, border];
  }
}

/** Numbers two by two. */
function pairs(numbers) {
  return Array.from({ length: numbers.length / 2 }, (_, at) => [numbers[2 * at], numbers[2 * at + 1]]);
}
