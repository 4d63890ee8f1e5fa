// Updates a served page: asks the server for changes every second.

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
      // After three failed requests, the server counts as ended.
      if (++failures === 3) return onEnd();
    }
    setTimeout(ask, 1000);
  };
  ask();
}
