// The lines of an adapter in JavaScript: a question in, triangles out. What the program throws counts as refused.
import { readFileSync } from "node:fs";
import { createInterface } from "node:readline";

export async function serve(name, triangulate) {
  const { version } = JSON.parse(readFileSync(`node_modules/${name}/package.json`));
  for await (const line of createInterface({ input: process.stdin })) {
    let answer;
    try {
      answer = { triangles: triangulate(JSON.parse(line)) };
    } catch (error) {
      answer = { refused: String(error).split("\n")[0].slice(0, 200) };
    }
    console.log(JSON.stringify({ ...answer, program: `${name} ${version}` }));
  }
}

// Triangles of a program that promises no sense of rotation, turned counter-clockwise (exact for integers of 20 bits).
export const turned = (points, triangles) =>
  triangles.map(([a, b, c]) => {
    const [[ax, ay], [bx, by], [cx, cy]] = [points[a], points[b], points[c]];
    return (bx - ax) * (cy - ay) - (by - ay) * (cx - ax) < 0 ? [a, c, b] : [a, b, c];
  });

// A flat list of corners, in threes.
export const threes = (corners) =>
  Array.from({ length: Math.floor(corners.length / 3) }, (_, t) => Array.from(corners.slice(3 * t, 3 * t + 3)));
