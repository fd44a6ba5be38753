/** The least values that bring a structure to its states; as in forficula.study.search, without its halvings. */

import { tells } from "./engine-outcome.js";

/** search: the steps with their values; runUntil: takes values by key through the protocol up to a stage. */
export function leastValues(search, runUntil) {
  const { first, second, reference, referenceText, release } = search;
  const found = decided(first, (value) => runUntil({ [first.key]: first.sign * value }, first.until));
  let { least, outcome: done } = found;
  if (least !== null && release !== null) {
    done = runUntil({ [first.key]: first.sign * least }, release);
    if (!tells(done.verdict)) least = null;
  }
  const withReference = { [first.key]: first.sign * reference };
  const later =
    least !== null && second
      ? decided(second, (value) => runUntil({ ...withReference, [second.key]: second.sign * value }, second.until))
      : { least: null, outcome: null };
  return {
    ...ending(first, done, later.outcome, referenceText),
    least: { [first.name]: least, ...(second ? { [second.name]: later.least } : {}) },
    transitions: [...(least === null ? [] : numbers(done, first)), ...(later.least === null ? [] : numbers(later.outcome, second))],
  };
}

/** The first of the values that reaches the state, with what came of it; or none, with what came of the last one. */
function decided(step, run) {
  let outcome = null;
  for (const value of step.values) {
    outcome = run(value);
    if (!tells(outcome.verdict)) return { least: null, outcome };
    if (reaches(outcome, step.transition)) return { least: value, outcome };
  }
  return { least: null, outcome };
}

const reaches = (outcome, transition) => Boolean(outcome.transitions.find(({ name }) => name === transition)?.took?.succeeded);

const numbers = (outcome, { transition }) => outcome.transitions.filter(({ name }) => name === transition);

/** What a point is said to have come to: where some value does the first transition, what became of the second. */
function ending(first, done, next, referenceText) {
  const { status, word, verdict, advice } = done;
  if (!next) return { status, word, verdict, advice };
  if (!reaches(done, first.transition)) return { status: `${status}; with ${referenceText}: ${next.status}`, word, verdict, advice };
  if (reaches(next, first.transition)) return { status: next.status, word: next.word, verdict: next.verdict, advice: next.advice };
  const said = { status: `with ${referenceText}: ${next.status}`, verdict: next.verdict, advice: next.advice };
  return { ...said, word: tells(next.verdict) ? `${next.word} with ${referenceText}` : next.word };
}
