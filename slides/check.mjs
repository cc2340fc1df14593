// check.mjs OUT: do both decks say the same, does no slide overflow, is no figure missing, do the
// notes fit into two halves of 45 minutes, is README.md's plan the notes'?
// OUT holds the built decks; CHROME_PATH is the browser. Prints what is wrong, one line each, and exits with 1.
import { existsSync, readFileSync, readdirSync } from 'node:fs';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import puppeteer from 'puppeteer-core';

const here = dirname(fileURLToPath(import.meta.url));
const out = resolve(process.argv[2]);
const languages = ['en', 'sv'];
const lastBeforeBreak = '08', half = 45; // chapter; minutes
let wrong = 0;
const say = (line) => {
  wrong++;
  console.log(`slides: ${line}`);
};

// ---- what the sources say --------------------------------------------------------------

const all = (text, pattern) => [...text.matchAll(pattern)].map((m) => m[0].replace(/\s+/g, ' '));

function slide(text) {
  const comments = all(text, /<!--[\s\S]*?-->/g);
  const seen = text.replace(/<!--[\s\S]*?-->/g, '');
  const code = all(seen, /```[\s\S]*?```/g);
  const prose = seen.replace(/```[\s\S]*?```/g, '');
  const words = /\\text\{[^}]*\}/g; // words in a formula are the language's own
  return {
    kind: comments.filter((c) => c.includes('_class')).join(),
    figures: all(prose, /!\[[^\]]*\]\([^)]*\)/g),
    formulas: all(prose, /\$\$[\s\S]*?\$\$|\$[^$]*\$/g).map((f) => f.replace(words, '')),
    code,
    notes: comments.filter((c) => !c.includes('_class')),
    demos: comments.flatMap((c) => all(c, /`make [^`]*`/g)),
    minutes: minutes(comments.join(' ')),
  };
}

function minutes(notes) {
  const time = notes.match(/(?:Time|Tid): (\d+(?:[.,]\d+)?) min\./);
  return time ? Number(time[1].replace(',', '.')) : 0;
}

function read(language, name) {
  const source = readFileSync(join(here, language, name), 'utf8');
  return source.split(/\n---\n/).map(slide);
}

const names = languages.map((l) => readdirSync(join(here, l)).filter((n) => n.endsWith('.md')).sort());
if (names[0].join() !== names[1].join()) say(`en/ and sv/ have different files: ${names.join(' | ')}`);

const sum = (numbers) => numbers.reduce((a, b) => a + b, 0);
const plan = []; // of the lecture: what README.md says in a table
for (const name of names[0].filter((n) => names[1].includes(n))) {
  const [en, sv] = languages.map((l) => read(l, name));
  if (en.length !== sv.length) say(`${name}: ${en.length} slides in English, ${sv.length} in Swedish`);
  for (let i = 0; i < Math.min(en.length, sv.length); i++)
    for (const part of ['kind', 'figures', 'formulas', 'code', 'demos', 'minutes'])
      if (String(en[i][part]) !== String(sv[i][part]))
        say(`${name}, slide ${i + 1}: the ${part} differ: ${en[i][part]} | ${sv[i][part]}`);
  for (const [language, slides] of [['en', en], ['sv', sv]])
    slides.forEach((s, i) => {
      if (!s.minutes) say(`${language}/${name}, slide ${i + 1}: no notes with "Time: N min." ("Tid: N min.")`);
      for (const f of s.figures) {
        const path = join(here, language, f.match(/\(([^)]*)\)/)[1]);
        if (!existsSync(path)) say(`${language}/${name}, slide ${i + 1}: there is no ${path}`);
      }
    });
  plan.push({
    name: name.replace(/\.md$/, ''),
    slides: en.length,
    minutes: sum(en.map((s) => s.minutes)),
    demos: [...new Set(en.flatMap((s) => s.demos))],
  });
}

function minutesOf(rows, where) {
  const total = sum(rows.map((r) => r.minutes));
  if (total > half) say(`${where} takes ${total} minutes, and may take ${half}`);
  return total;
}
const first = minutesOf(plan.filter((p) => p.name.slice(0, 2) <= lastBeforeBreak), 'the first half');
const second = minutesOf(plan.filter((p) => p.name.slice(0, 2) > lastBeforeBreak), 'the second half');
// `make 06 ARGS="--show fuzzy"`, `make 06`: `make 06`; fuzzy
function demos(commands) {
  const shows = commands.flatMap((c) => [...c.matchAll(/ARGS="(?:--show )?([^"]*)"/g)].map((m) => m[1]));
  const makes = [...new Set(commands.map((c) => c.replace(/ ARGS="[^"]*"/, '')))].sort();
  return makes.join(', ') + (shows.length ? `; ${shows.join(', ')}` : '');
}
const readme = readFileSync(join(here, 'README.md'), 'utf8');
for (const p of plan) {
  const row = `| ${p.name} | ${p.slides} | ${p.minutes} | ${demos(p.demos)} |`;
  if (!readme.includes(row)) say(`README.md should say: ${row}`);
}
for (const total of [first, second])
  if (!readme.includes(`**${total}**`)) say(`README.md should say that a half takes **${total}** minutes`);

// ---- what the browser shows ---------------------------------------------------------------

const browser = await puppeteer.launch({
  executablePath: process.env.CHROME_PATH,
  args: ['--no-sandbox', '--allow-file-access-from-files'],
  timeout: 120000, // milliseconds: a busy machine starts it slowly
});
let count = 0;
for (const language of languages) {
  const page = await browser.newPage();
  await page.goto(pathToFileURL(join(out, `${language}.html`)).href, { waitUntil: 'networkidle0', timeout: 120000 });
  await page.evaluate(async () => { // what has not come yet has no size
    await document.fonts.ready;
    const come = (img) => new Promise((done) => (img.complete ? done() : (img.onload = img.onerror = done)));
    await Promise.all([...document.images].map(come));
    await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
  });
  const slides = await page.$$eval('section[id]', (sections) =>
    sections.map((s) => {
      const box = s.getBoundingClientRect(), scale = box.height / s.offsetHeight;
      const style = getComputedStyle(s);
      const bottom = box.bottom - (parseFloat(style.paddingBottom) * scale) / 2;
      const right = box.right - (parseFloat(style.paddingRight) * scale) / 2;
      const low = [...s.querySelectorAll('*')]
        .filter((e) => !e.closest('mjx-assistive-mml') && e.getClientRects().length)
        .map((e) => e.getBoundingClientRect());
      // Do words stand on a picture? What lies in the page's background is no concern of this.
      const pictures = [...s.querySelectorAll('p > img')].map((e) => e.getBoundingClientRect());
      const words = [...s.querySelectorAll('h1, h2, p, li, pre, table, mjx-container')]
        .filter((e) => !e.querySelector('img'))
        .flatMap((e) => {
          const range = document.createRange();
          range.selectNodeContents(e);
          return [...range.getClientRects()];
        });
      const covered = pictures.some((p) => words.some((w) =>
        Math.min(p.right, w.right) - Math.max(p.left, w.left) > 2 * scale &&
        Math.min(p.bottom, w.bottom) - Math.max(p.top, w.top) > 2 * scale));
      const broken = [...s.querySelectorAll('img')].filter((i) => !i.naturalWidth).map((i) => i.src);
      return {
        title: (s.querySelector('h1, h2') || s).textContent.trim().slice(0, 40),
        tall: Math.round(Math.max(0, ...low.map((r) => r.bottom - bottom)) / scale),
        wide: Math.round(Math.max(0, ...low.map((r) => r.right - right)) / scale),
        broken,
        covered,
        dollars: /\$/.test(s.textContent),
        cut: [...s.querySelectorAll('pre')].some((e) => {
          const words = document.createRange();
          words.selectNodeContents(e);
          const room = e.getBoundingClientRect().right - parseFloat(getComputedStyle(e).paddingRight) * scale;
          return words.getBoundingClientRect().right > room + scale || e.scrollWidth > e.clientWidth;
        }),
        errors: s.querySelectorAll('mjx-merror, [data-mml-node="merror"], [data-mjx-error]').length,
      };
    }));
  slides.forEach((s, i) => {
    count++;
    const where = `${language}, page ${i + 1} (${s.title})`;
    if (s.tall > 0) say(`${where}: ${s.tall} pixels too tall`);
    if (s.wide > 0) say(`${where}: ${s.wide} pixels too wide`);
    if (s.covered) say(`${where}: words stand on the picture`);
    if (s.cut) say(`${where}: code wider than its column`);
    if (s.dollars) say(`${where}: a formula is shown as text: a blank beside its $`);
    if (s.errors) say(`${where}: a formula is broken`);
    for (const b of s.broken) say(`${where}: a picture is not shown: ${b}`);
  });
  await page.close();
}
await browser.close();
if (wrong) process.exit(1);
console.log(`slides: ${count} pages say the same in both languages, none overflows; ${first} and ${second} minutes`);
