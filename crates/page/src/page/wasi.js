// A process of a program for WASI preview 1: it has arguments, standard streams, a clock and random bytes, and no
// files. https://github.com/WebAssembly/WASI/blob/main/legacy/preview1/docs.md

/** What functions of WASI return. */
const [SUCCESS, BAD_DESCRIPTOR, NOT_SUPPORTED] = [0, 8, 58];

/** Thrown to end a program, since it never returns from `proc_exit`. */
class Exit extends Error {
  constructor(status) {
    super(`exit status ${status}`);
    this.status = status;
  }
}

/** Runs a compiled program to its end: its status, and what it has written to its standard streams. */
function runProgram(module, args, input) {
  const written = { 1: [], 2: [] };
  const end = (status) => ({ status, output: joined(written[1]), errors: text(joined(written[2])) });
  let memory = null;
  const functions = wasi(() => memory, args, input, written);
  const absent = { get: (known, name) => known[name] ?? (() => NOT_SUPPORTED) };
  const instance = new WebAssembly.Instance(module, {
    wasi_snapshot_preview1: new Proxy(functions, absent),
  });
  memory = instance.exports.memory;
  try {
    instance.exports._start();
    return end(0);
  } catch (error) {
    if (error instanceof Exit) {
      return end(error.status);
    }
    // A trap: a panic, whose message stands in `errors`, or no memory.
    return { ...end(null), trap: String(error) };
  }
}

/** The functions that a program imports. The memory may be another one after each growth. */
function wasi(memoryNow, args, input, written) {
  const words = args.map((word) => new TextEncoder().encode(`${word}\0`));
  const view = () => new DataView(memoryNow().buffer);
  const bytes = (at, length) => new Uint8Array(memoryNow().buffer, at, length);
  let read = 0;

  /** Calls a function for each part of a list of parts of the memory, until it returns 0; the sum. */
  const eachPart = (parts, count, act) => {
    let sum = 0;
    for (let part = 0; part < count; part++) {
      const at = parts + 8 * part;
      const done = act(bytes(view().getUint32(at, true), view().getUint32(at + 4, true)));
      sum += done;
      if (done === 0) {
        break;
      }
    }
    return sum;
  };

  return {
    args_sizes_get(count, size) {
      view().setUint32(count, words.length, true);
      view().setUint32(size, words.reduce((sum, word) => sum + word.length, 0), true);
      return SUCCESS;
    },
    args_get(list, to) {
      for (const [position, word] of words.entries()) {
        view().setUint32(list + 4 * position, to, true);
        bytes(to, word.length).set(word);
        to += word.length;
      }
      return SUCCESS;
    },
    environ_sizes_get(count, size) {
      view().setUint32(count, 0, true);
      view().setUint32(size, 0, true);
      return SUCCESS;
    },
    environ_get: () => SUCCESS,
    fd_read(descriptor, parts, count, size) {
      if (descriptor !== 0) {
        return BAD_DESCRIPTOR;
      }
      const sum = eachPart(parts, count, (part) => {
        const piece = input.subarray(read, read + part.length);
        part.set(piece);
        read += piece.length;
        return piece.length;
      });
      view().setUint32(size, sum, true);
      return SUCCESS;
    },
    fd_write(descriptor, parts, count, size) {
      const pieces = written[descriptor];
      if (!pieces) {
        return BAD_DESCRIPTOR;
      }
      let sum = 0;
      eachPart(parts, count, (part) => {
        pieces.push(part.slice());
        sum += part.length;
        return 1;
      });
      view().setUint32(size, sum, true);
      return SUCCESS;
    },
    clock_time_get(_clock, _precision, time) {
      view().setBigUint64(time, BigInt(Math.round(performance.now() * 1e6)), true);
      return SUCCESS;
    },
    random_get(at, length) {
      for (let from = 0; from < length; from += 65536) {
        crypto.getRandomValues(bytes(at + from, Math.min(65536, length - from)));
      }
      return SUCCESS;
    },
    fd_prestat_get: () => BAD_DESCRIPTOR,
    proc_exit(status) {
      throw new Exit(status);
    },
  };
}

/** Pieces one after the other. */
function joined(pieces) {
  const all = new Uint8Array(pieces.reduce((sum, piece) => sum + piece.length, 0));
  let at = 0;
  for (const piece of pieces) {
    all.set(piece, at);
    at += piece.length;
  }
  return all;
}

const text = (bytes) => new TextDecoder().decode(bytes);
