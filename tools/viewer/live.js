// A page that is served asks every second what is new beside it.

export function watch(onPage, onEnd) {
  let last = '';
  let failures = 0;
  const ask = async () => {
    try {
      const text = await (await fetch('page.json')).text();
      failures = 0;
      if (text !== last && last !== '') onPage(JSON.parse(text));
      last = text;
    } catch {
      // A server that has ended does not come back.
      if (++failures === 3) return onEnd();
    }
    setTimeout(ask, 1000);
  };
  ask();
}
