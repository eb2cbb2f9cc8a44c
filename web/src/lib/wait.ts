// Answers mostly come at once: then nothing is drawn for the moment between. Only who has to wait
// is told so.

/** What `answer` brings; `meanwhile` is called if that takes longer than a moment. */
export async function waiting<T>(
  answer: Promise<T>,
  signal: AbortSignal,
  meanwhile: () => void,
): Promise<T> {
  const timer = window.setTimeout(() => !signal.aborted && meanwhile(), 250);
  try {
    return await answer;
  } finally {
    window.clearTimeout(timer);
  }
}
