/**
 * The simulator as the pages have it: MuJoCo's own WebAssembly, whose script makes no function from text any more, for
 * that is what a security policy without 'unsafe-eval' refuses.
 */

/** What binds functions of C++ by closures, in place of text that is evaluated: arguments go to the wire one by one. */
const INVOKER = `
      var invokerFn = function (...given) {
        checkArgCount(given.length, minArgs, expectedArgCount, humanName, throwBindingError);
        var destructors = needsDestructorStack ? [] : null;
        var wired = isClassMethodFunc ? [argTypes[1]["toWireType"](destructors, this)] : [];
        for (var i = 0; i < expectedArgCount; ++i) wired.push(argTypes[i + 2]["toWireType"](destructors, given[i]));
        var rv = cppInvokerFunc(cppTargetFunc, ...wired);
        if (needsDestructorStack) runDestructors(destructors);
        else {
          for (var first = isClassMethodFunc ? 1 : 2, i = first; i < argTypes.length; ++i)
            if (argTypes[i].destructorFunction !== null) argTypes[i].destructorFunction(wired[i - first]);
        }
        if (returns) return argTypes[0]["fromWireType"](rv);
      };
`;

/** Alike for what C++ calls of JavaScript. */
const CALLER = `
      var invokerFunction = function (obj, func, destructorsRef, args) {
        var read = [], at = 0;
        for (var i = 0; i < argCount; ++i) {
          read.push(types[i].readValueFromPointer(args + at));
          at += types[i].argPackAdvance;
        }
        var rv = kind === 1 ? new func(...read) : kind === 0 ? func.call(obj, ...read) : func.call(...read);
        if (!retType.isVoid) return emval_returnValue(retType, destructorsRef, rv);
      };
`;

// where the script is read again, each once: what stands there, and what comes in its place
const CHANGES = [
  ["let [args, invokerFnBody] = createJsInvoker(argTypes, isClassMethodFunc, returns, isAsync);", ""],
  ["var invokerFn = new Function(...args, invokerFnBody)(...closureArgs);", INVOKER],
  ["var invokerFunction = new Function(...params, functionBody)(...args);", CALLER],
  // it is always in a worker, and its program is always handed to it
  ["var ENVIRONMENT_IS_WEB = typeof window == 'object';", "var ENVIRONMENT_IS_WEB = false;"],
  ["var ENVIRONMENT_IS_WORKER = typeof WorkerGlobalScope != 'undefined';", "var ENVIRONMENT_IS_WORKER = true;"],
  [
    "var ENVIRONMENT_IS_NODE = typeof process == 'object' && process.versions?.node && process.type != 'renderer';",
    "",
  ],
  [
    "if (!(typeof window == 'object' || typeof WorkerGlobalScope != 'undefined')) throw new Error('not compiled for this environment (did you build to HTML and try to run it not on the web, or set ENVIRONMENT to something - like node - and run it someplace else - like on the web?)');",
    "",
  ],
  ["var _scriptName = import.meta.url;", "var _scriptName = '';"],
  ["return new URL('mujoco.wasm', import.meta.url).href;", "return 'mujoco.wasm';"],
  ["const { createRequire } = await import('module');", ""],
  ["var require = createRequire(import.meta.url);", ""],
];

/** The engine's script with these changes; another version of it, which reads otherwise, is refused. */
export function patched(script) {
  for (const [found, put] of CHANGES) {
    const count = script.split(found).length - 1;
    if (count !== 1) throw new Error(`the engine's script has ${count} times what is to be changed once: ${found}`);
    script = script.replace(found, () => put);
  }
  // what is for Node.js alone is left out of the bundle
  script = script.replaceAll("ENVIRONMENT_IS_NODE", "false");
  if (/new Function\b|\beval\(/.test(script)) throw new Error("the engine's script still makes functions from text");
  return script;
}
