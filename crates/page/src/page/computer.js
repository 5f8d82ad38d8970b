// The worker that computes, and its queue of requests.

/** The text of an element that holds data or another script. */
const embedded = (id) => document.getElementById(id).textContent.trim();

/** The compiled program: base64 of a gzip file in the page. */
async function loadProgram() {
  const packed = Uint8Array.from(atob(embedded("program")), (letter) => letter.charCodeAt(0));
  const unpacked = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  return WebAssembly.compile(await new Response(unpacked).arrayBuffer());
}

class Computer {
  constructor() {
    this.program = loadProgram();
    this.address = URL.createObjectURL(new Blob([embedded("worker")], { type: "text/javascript" }));
    /** The end of the queue. */
    this.last = Promise.resolve();
    this.worker = null;
    this.interrupt = null;
  }

  /** The answer to a request, as the worker gives it, after those to all requests before it. */
  ask(request, files) {
    const answer = this.last.then(() => this.answer(request, files));
    this.last = answer.catch(() => null);
    return answer;
  }

  async answer(request, files) {
    const program = await this.program;
    if (!this.worker) {
      this.worker = new Worker(this.address);
      this.worker.postMessage({ program });
    }
    return new Promise((resolve) => {
      this.worker.onmessage = ({ data }) => resolve(data);
      this.worker.onerror = (event) => this.stop(`The worker failed: ${event.message}`);
      this.interrupt = (errors) => resolve({ status: null, errors, output: new Uint8Array() });
      this.worker.postMessage({ request, files });
    });
  }

  /** Ends the computation; its answer is that it was stopped. */
  stop(reason = "Stopped.") {
    this.worker?.terminate();
    this.worker = null;
    this.interrupt?.(reason);
  }
}

/** What to tell of an answer that is a failure. */
function failure({ status, errors, trap }) {
  if (trap && !errors.includes("panicked")) {
    return `The browser has not enough memory for this. ${errors || trap}`;
  }
  return errors.trim() || `The program ended with status ${status}.`;
}
