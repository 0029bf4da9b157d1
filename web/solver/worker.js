
// Behind what Emscripten writes. In a worker it takes the compiled module first, then requests, one after the other.
if (typeof importScripts === 'function' && typeof document === 'undefined') {
  let solver;
  self.onmessage = ({ data }) => {
    if (data instanceof WebAssembly.Module) {
      solver = makeSolver({
        instantiateWasm(imports, ready) {
          WebAssembly.instantiate(data, imports).then((instance) => ready(instance, data));
          return {};
        },
      });
      return;
    }
    solver.then((module) => self.postMessage(answerOf(module, data)));
  };
}

// The answer of the solver to a request; behind a "!" what kept it from one.
function answerOf(module, request) {
  const size = module.lengthBytesUTF8(request) + 1;
  const place = module._malloc(size);
  module.stringToUTF8(request, place, size);
  const answer = module.UTF8ToString(module._bumpfoil_answer(place));
  module._free(place);
  return answer;
}
if (typeof module === 'object') module.exports.answerOf = answerOf;
