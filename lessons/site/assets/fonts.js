// Shows the page once its fonts are there, so that no line breaks twice. After a second and a half it goes without them: they come
// with the next page.
{
  const root = document.documentElement;
  const wanted = ['', 'bold ', 'italic '].map(style => `${style}1em "Course Serif"`)
    .concat('1em "Course Sans"', 'bold 1em "Course Sans"', '1em "Course Math"');
  const late = new Promise((_, reject) => setTimeout(reject, 1500));
  root.style.visibility = 'hidden';
  Promise.race([Promise.all(wanted.map(font => document.fonts.load(font))), late])
    .catch(() => {
      for (const family of ['--serif', '--sans', '--math'])
        root.style.setProperty(family, getComputedStyle(root).getPropertyValue(family).replace(/"Course \w+",/, ''));
    })
    .finally(() => { root.style.visibility = ''; });
}
