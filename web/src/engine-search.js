/** The least values with which a structure reaches its states; same rules as forficula.study.search, without halvings. */

import { isConclusive } from "./engine-outcome.js";
import { filled } from "./format.js";

/** search: the steps with their values; runUntil: runs the protocol with values by key up to a stage. */
export function leastValues(search, runUntil) {
  const { first, second, reference, referenceText, release } = search;
  const found = decided(first, (value) => runUntil({ [first.key]: first.sign * value }, first.until));
  let { least, outcome: done } = found;
  if (least !== null && release !== null) {
    done = runUntil({ [first.key]: first.sign * least }, release);
    if (!isConclusive(done.verdict)) least = null;
  }
  const withReference = { [first.key]: first.sign * reference };
  const later =
    least !== null && second
      ? decided(second, (value) => runUntil({ ...withReference, [second.key]: second.sign * value }, second.until))
      : { least: null, outcome: null, last: null };
  return {
    ...ending(search, { ...found, outcome: done }, later),
    least: { [first.name]: least, ...(second ? { [second.name]: later.least } : {}) },
    transitions: [...(least === null ? [] : numbers(done, first)), ...(later.least === null ? [] : numbers(later.outcome, second))],
  };
}

/** The first value that reaches the state, with its outcome; otherwise none, with the outcome of the last value. */
function decided(step, run) {
  let outcome = null;
  let last = null;
  for (const [place, value] of step.values.entries()) {
    outcome = run(value);
    last = place;
    if (!isConclusive(outcome.verdict)) return { least: null, outcome, last };
    if (reaches(outcome, step.transition)) return { least: value, outcome, last };
  }
  return { least: null, outcome, last };
}

const reaches = (outcome, transition) => Boolean(outcome.transitions.find(({ name }) => name === transition)?.took?.succeeded);

const numbers = (outcome, { transition }) => outcome.transitions.filter(({ name }) => name === transition);

/** The status of a point: if some value completes the first transition, the outcome of the second. */
function ending({ first, second, referenceText: value, texts }, { outcome: done, last }, { outcome: next, last: lastNext }) {
  const { status: text, word, verdict, advice } = done;
  const named = (transition, at) => filled(texts.with, { text: transition, value: at });
  const used = (status, ...values) => filled(texts.used, { text: status, used: values.join(", ") });
  if (!next) return { status: first.texts && isConclusive(verdict) ? used(text, named(first.transition, first.texts[last])) : text, word, verdict, advice };
  if (!reaches(done, first.transition)) return { status: filled(texts.then, { text, value, next: next.status }), word, verdict, advice };
  if (reaches(next, first.transition)) {
    const status = first.texts ? used(next.status, named(first.transition, value), named(second.transition, second.texts[lastNext])) : next.status;
    return { status, word: next.word, verdict: next.verdict, advice: next.advice };
  }
  const said = { status: filled(texts.failed, { value, next: next.status }), verdict: next.verdict, advice: next.advice };
  return { ...said, word: isConclusive(next.verdict) ? named(next.word, value) : next.word };
}
