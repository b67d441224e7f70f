// Checks of npm test: each says its line, is counted, and is not run again on what it has passed on.

import { passedOn } from "./passed.mjs";
import { StepError, step } from "./steps.mjs";

/** What all checks of this run came to; `earlier` of those that passed did so in another run. */
export const total = { passed: 0, failed: 0, earlier: 0, failedSteps: [] };

/** Whether what has passed runs all the same. */
let again = false;
export function runAgain() {
  again = true;
}

/** A check as a whole that came to nothing. */
function failed(name, error) {
  if (!(error instanceof StepError)) throw error;
  total.failed += 1;
  total.failedSteps.push(name);
  console.log(error.output.split("\n").slice(-60).join("\n"));
  console.log(`✗ ${error.message}`);
}

function countPassed(name, passed) {
  total.passed += passed;
  total.earlier += passed;
  console.log(`• ${name} … unchanged since it passed${passed === 1 ? "" : ` (${passed})`}`);
}

/** A check that passes or fails as a whole and counts as one. */
export async function check(name, action) {
  try {
    const { earlier, keep } = await passedOn(name);
    if (earlier !== undefined && !again) return countPassed(name, 1);
    await step(name, {}, action);
    total.passed += 1;
    await keep(1);
  } catch (error) {
    failed(name, error);
  }
}

/**
 * A suite of tests with counts of its own; one that cannot be built or started is one that failed, and so is one
 * without tests. Files that match `unread` are none of its business. With `inParts` some of its tests are meant, which
 * says nothing about the rest.
 */
export async function suite(name, action, { unread, inParts = false } = {}) {
  let result;
  try {
    const { earlier, keep } = await passedOn(name, unread);
    if (earlier !== undefined && !again) return countPassed(name, earlier);
    await step(name, {}, async () => {
      result = await action();
      if (result.passed + result.failed === 0) throw new StepError("no test was run");
      return `${result.passed} passed, ${result.failed} failed`;
    });
    if (result.failed === 0 && !inParts) await keep(result.passed);
  } catch (error) {
    return failed(name, error);
  }
  for (const note of result.notes ?? []) console.log(`    ${note}`);
  total.passed += result.passed;
  total.failed += result.failed;
  if (result.failed > 0) {
    total.failedSteps.push(name);
    console.log(result.failures);
  }
}
