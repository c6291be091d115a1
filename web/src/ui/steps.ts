// Work that takes long, in steps, between which the page does all else that it has to.
const STEP_MS = 20; // of work at once

// After the next frame, as long as it is wanted.
export function inSteps(steps: Iterator<void>, isWanted: () => boolean): void {
  const goOn = (): void => {
    if (!isWanted()) return;
    for (const until_ms = performance.now() + STEP_MS; performance.now() < until_ms; ) if (steps.next().done) return;
    setTimeout(goOn);
  };
  requestAnimationFrame(() => setTimeout(goOn));
}
