// The worker: first it gets the compiled program, then requests; each is a process.

let program = null;

self.onmessage = ({ data }) => {
  if (data.program) {
    program = data.program;
    return;
  }
  const start = performance.now();
  const answer = runProgram(program, ["sweep-cdt-compute", JSON.stringify(data.request)], data.files);
  answer.milliseconds = performance.now() - start;
  self.postMessage(answer, [answer.output.buffer]);
};
