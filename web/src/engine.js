/** The engine of a page, in a worker made from the page's contents: it loads nothing and blocks nothing. */

import { unpack } from "./clip.js";

/** Whether the page has an engine. */
export function hasEngine() {
  return document.getElementById("engine-program") !== null;
}

/**
 * Start the engine with the data of a structure; `hear` receives its messages other than replies.
 *
 * Returns {first, ask, send, take, end}: the first frame, and functions that send a request, send a message, and load
 * another structure, which returns the same again.
 */
export async function startEngine(text, hear) {
  const packed = new Blob([unpack(document.getElementById("engine-script").textContent, Uint8Array)]).stream();
  const script = await new Response(packed.pipeThrough(new DecompressionStream("deflate"))).text();
  const address = URL.createObjectURL(new Blob([script], { type: "text/javascript" }));
  const worker = new Worker(address);
  const waiting = new Map();
  let asked = 0;

  worker.onmessage = ({ data }) => {
    const done = waiting.get(data.to);
    if (done) {
      waiting.delete(data.to);
      if (data.said === "refused") done.refuse(new Error(data.why));
      else done.take(data);
    } else hear(data);
  };
  worker.onerror = (event) => {
    event.preventDefault();
    const error = new Error(event.message || "the engine stopped");
    for (const { refuse } of waiting.values()) refuse(error);
    waiting.clear();
    hear({ said: "refused", why: error.message });
  };

  function ask(message) {
    const number = ++asked;
    return new Promise((take, refuse) => {
      waiting.set(number, { take, refuse });
      worker.postMessage({ ...message, number });
    });
  }

  function end() {
    worker.terminate();
    URL.revokeObjectURL(address);
  }

  try {
    const program = document.getElementById("engine-program").textContent;
    const { frame, version } = await ask({ act: "load", program, text });
    const engine = { first: frame, version, ask, send: (message) => worker.postMessage(message), take, end };
    return engine;

    async function take(another, listen) {
      const { frame: begun } = await ask({ act: "load", text: another });
      hear = listen;
      return { ...engine, first: begun };
    }
  } catch (error) {
    end();
    throw error;
  }
}
