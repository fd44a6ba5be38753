/** Requests of a workbench's page to its server, which alone reads, builds and surveys designs. */

const HEADERS = { "Content-Type": "application/json" };
const LARGEST = 19e6; // bytes of a request, slightly below the server's limit

/** Send a request about a design; returns the reply, or {refused} on failure; throws an AbortError if aborted. */
export async function ask(what, asked, signal) {
  const body = JSON.stringify(asked);
  if (body.length > LARGEST) return { refused: `need files of at most ${LARGEST / 1e6} MB in all` };
  try {
    const reply = await fetch(what, { method: "POST", headers: HEADERS, body, signal });
    return await reply.json();
  } catch (error) {
    if (error.name === "AbortError") throw error;
    return { refused: GONE };
  }
}

/** Send a request that is answered line by line: `hear` receives each line; returns the last one, {done} or {refused}. */
export async function follow(what, asked, signal, hear) {
  let rest = "";
  let last = {};
  try {
    const reply = await fetch(what, { method: "POST", headers: HEADERS, body: JSON.stringify(asked), signal });
    const lines = reply.body.pipeThrough(new TextDecoderStream()).getReader();
    for (let part = await lines.read(); !part.done; part = await lines.read()) {
      const texts = `${rest}${part.value}`.split("\n");
      rest = texts.pop();
      for (const text of texts) {
        last = JSON.parse(text);
        hear(last);
      }
    }
    if (rest) last = JSON.parse(rest);
  } catch (error) {
    if (error.name === "AbortError") throw error;
    return { refused: GONE };
  }
  return last.done || last.refused ? last : { refused: GONE };
}

const GONE = "the workbench does not answer; is forficula open still running?";
