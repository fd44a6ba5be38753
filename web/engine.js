/**
 * The simulator of the pages: MuJoCo's own WebAssembly. Its script is changed so that it makes no function from text,
 * because a security policy without 'unsafe-eval' refuses that.
 */

/** Binds functions of C++ by closures, instead of evaluating text: arguments are converted one by one. */
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

/** The same for calls from C++ to JavaScript. */
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

// replacements, each of a text that occurs exactly once
const CHANGES = [
  ["let [args, invokerFnBody] = createJsInvoker(argTypes, isClassMethodFunc, returns, isAsync);", ""],
  ["var invokerFn = new Function(...args, invokerFnBody)(...closureArgs);", INVOKER],
  ["var invokerFunction = new Function(...params, functionBody)(...args);", CALLER],
  // the engine always runs in a worker, and its program is always passed to it
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

/** The engine's script with these changes; throws an error for another version, whose text differs. */
export function patched(script) {
  for (const [found, put] of CHANGES) {
    const count = script.split(found).length - 1;
    if (count !== 1) throw new Error(`the engine's script has ${count} occurrences of a text that must occur once: ${found}`);
    script = script.replace(found, () => put);
  }
  // code for Node.js is left out of the bundle
  script = script.replaceAll("ENVIRONMENT_IS_NODE", "false");
  if (/new Function\b|\beval\(/.test(script)) throw new Error("the engine's script still makes functions from text");
  return script;
}
