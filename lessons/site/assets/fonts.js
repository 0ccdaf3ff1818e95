// Shows the page once its fonts are there, so that no line breaks twice. After a second and a half it goes without them: they come
// with the next page.
{
  const root = document.documentElement;
  const wanted = [...document.fonts].filter(face => /^"?Course (Serif|Sans|Math)"?$/.test(face.family));
  const late = new Promise((_, reject) => setTimeout(reject, 1500));
  root.style.visibility = 'hidden';
  Promise.race([Promise.all(wanted.map(face => face.load())), late])
    .catch(() => {
      for (const family of ['--serif', '--sans', '--math'])
        root.style.setProperty(family, getComputedStyle(root).getPropertyValue(family).replace(/"Course \w+",/, ''));
    })
    .finally(() => { root.style.visibility = ''; });
}
