// Runs a program for wasm32-unknown-unknown and ends with the status that its `main` returns.
import { readFile } from "node:fs/promises";

const { instance } = await WebAssembly.instantiate(await readFile(process.argv[2]), {});
process.exitCode = instance.exports.main(0, 0);
