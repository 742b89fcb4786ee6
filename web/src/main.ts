// The laboratory: puts the parts together.

import './generated/palette.css';
import './style/theme.css';
import './style/base.css';
import './style/page.css';
import './style/panes.css';
import './style/hoop.css';
import './style/dialogue.css';
import './style/levels.css';
import './style/screens.css';
import './style/embed.css';
import './style/lecture.css';
import { namesAgree } from './core/motion';
import { cases as casesOfCore, provokePanic, startCore } from './core/wasm';
import { byId, inSight } from './dom';
import { otherLanguage } from './language';
import { type Change, Lab } from './state/lab';
import { type NamedCase, rateOf, type State, type Theme } from './state/state';
import { type FieldError, format, parse } from './state/url';
import { Address, HAS_ADDRESS } from './ui/address';
import { Ask } from './ui/ask';
import { Clock } from './ui/clock';
import { Compare } from './ui/compare';
import { showDefect, watch } from './ui/defect';
import { watchDrags } from './ui/drag';
import { Embedding } from './ui/embedding';
import { EnergyBar } from './ui/energy-bar';
import { Fields } from './ui/fields';
import { HoopPane } from './ui/hoop-pane';
import { Host } from './ui/host';
import { ImpactPane } from './ui/impact-pane';
import { Lecture } from './ui/lecture';
import { Level } from './ui/level';
import { Mark } from './ui/mark';
import { MovesPane } from './ui/moves-pane';
import { OwnLesson } from './ui/own-lesson';
import { PhaseTable } from './ui/phase-table';
import { PlanePane } from './ui/plane-pane';
import { ProblemBar } from './ui/problem-bar';
import { Share } from './ui/share';
import { Story } from './ui/story';
import { type Asked, partsOf, writeTexts } from './ui/texts';
import { isDark, onSystemTheme, paletteOf, setTheme } from './ui/theme';
import { Transport } from './ui/transport';
import { Words } from './ui/words';
import { Plots } from './views/plots';

/** How long the address waits, so that a drag does not write it at every step. */
const ADDRESS_PAUSE = 250;

watch();
writeTexts();
await startCore(showDefect);
if (!namesAgree()) throw new Error('page and core have different versions');
start(JSON.parse(casesOfCore()) as NamedCase[]);

function start(cases: NamedCase[]): void {
  if (location.hash === '#panic') provokePanic();
  const plain = parse('').state;
  // A frame does not compute, even for a moment, what it does not show.
  const { embed } = parse(location.hash, plain).state.view;
  const first: State = { ...plain, view: { ...plain.view, embed } };
  const lab = new Lab(first, cases);
  const address: Address = new Address(lab, () => ask.asked?.text ?? null);
  setTheme(first.view.theme);

  let palette = paletteOf(first.view.theme);
  let frame = 0;
  const draw = (): void => {
    if (frame === 0) frame = requestAnimationFrame(paint);
  };
  const level = new Level(lab);
  const clock: Clock = new Clock(
    lab,
    () => lab.state.view.slow || level.isSimple || ask.asked !== null,
    () => {
      transport.showView();
      ask.showTime();
      if (!clock.playing) writeSoon(lab, host, address);
    },
  );
  const go = (time: number): void => {
    clock.pause();
    lab.setTime(time);
    // What is shown of the instant may be out of view.
    byId('hoop', HTMLCanvasElement).scrollIntoView({ block: 'nearest' });
  };
  /** Letters, forces in numbers and what is predicted are for lessons and the full view. */
  const isPlain = (): boolean => level.isSimple && ask.asked === null;
  const hoop = new HoopPane(lab, clock, palette, isPlain, draw);
  const isWhole = (): boolean => !lab.state.view.embed && !level.isSimple;
  const plane = new PlanePane(lab, palette, isWhole, draw, showDefect);
  const plots = new Plots(byId('plots', HTMLDivElement), palette, (time) => {
    clock.pause();
    lab.setTime(time);
  });
  const fields = new Fields(byId('fields', HTMLDivElement), lab);
  const bar = new ProblemBar(lab, (problem) => {
    clock.pause();
    origin = problem;
  });
  const words = new Words(lab);
  const compare = new Compare(lab);
  const mark = new Mark(lab);
  const ask: Ask = new Ask(
    lab,
    clock,
    () => level.isSimple,
    (asked) => openLesson(asked),
  );
  const transport = new Transport(lab, clock);
  const story = new Story(lab);
  const phases = new PhaseTable(lab, go);
  const energy = new EnergyBar(lab);
  const impact = new ImpactPane(lab, palette, draw, go);
  const moves = new MovesPane(lab, draw, showDefect);
  watchDrags(lab);
  new Share(
    lab,
    {
      hoop: (c, width, height) => hoop.drawOn(c, width, height),
      film: (c, width, height, time) => hoop.drawOn(c, width, height, time),
      plane: (c, width, height) => plane.drawOn(c, width, height),
      impact: (c, width, height) => impact.drawOn(c, width, height),
    },
    () => palette,
    () => address.text,
  );
  new OwnLesson(({ text }) => address.textOf(lab.state.problem, text));
  const embedding = new Embedding(lab);
  const lecture = new Lecture(
    lab,
    (problem) => address.textOf(problem),
    () => {
      stale.motion = true;
      draw();
    },
  );

  /** What is out of sight is drawn when it comes. */
  const plotsInSight = inSight(byId('plots', HTMLDivElement), draw);
  const stale = { motion: true, time: true, tables: false };
  function paint(): void {
    frame = 0;
    hoop.paint();
    if (!isWhole()) return;
    paintPlots();
    plane.paint();
    impact.paint();
    moves.paint();
  }

  function paintPlots(isPrinted = false): void {
    if (!plotsInSight() && !isPrinted) return;
    if (stale.motion) {
      const { motion, units, pinned, state } = lab;
      plots.setMotion({
        motion,
        units,
        system: state.problem.system,
        pinned: pinned?.motion ?? null,
        available: lab.plain.mu_s,
      });
    }
    if (stale.motion || stale.time) plots.setTime(lab.time);
    stale.motion = false;
    stale.time = false;
  }

  const showTheme = (): void => {
    setTheme(lab.state.view.theme);
    palette = paletteOf(lab.state.view.theme);
    hoop.setPalette(palette);
    plane.setPalette(palette);
    plots.setPalette(palette);
    impact.setPalette(palette);
    draw();
  };
  let theme: Theme = lab.state.view.theme;
  let reading = false;

  /** What the simple view has not. */
  const showTables = (): void => {
    stale.tables = false;
    fields.show();
    bar.show();
    phases.showMotion();
    impact.showMotion();
    moves.showMotion();
  };

  lab.onChange((changes: ReadonlySet<Change>) => {
    if (changes.has('motion')) {
      stale.motion = true;
      transport.showMotion();
      story.showMotion();
      words.showMotion();
      compare.showMotion();
      ask.showMotion();
      energy.showMotion();
    }
    stale.tables ||= changes.has('motion') || changes.has('errors');
    if (changes.has('errors') && !reading) showLinkErrors([]);
    if (changes.has('view')) {
      embedding.showView();
      level.showView();
      lecture.showTime();
      ask.showSecret();
      transport.showView();
      hoop.viewChanged();
      plane.viewChanged();
      if (lab.state.view.theme !== theme) {
        theme = lab.state.view.theme;
        showTheme();
      }
    }
    // Out of sight they wait for the end of a drag, which has the time.
    if (stale.tables && !(level.hidesTables && lab.held)) showTables();
    else if (stale.tables && !level.isSimple) fields.show();
    if (changes.has('hoop')) plane.hoopChanged();
    if (changes.has('time')) {
      stale.time = true;
      transport.showTime();
      story.showTime();
      ask.showTime();
      lecture.showTime();
      mark.showTime();
      energy.showTime();
      if (!stale.tables) {
        phases.showTime();
        impact.showTime();
      }
    }
    plane.motionChanged();
    draw();
    address.changed();
    // While it plays, the time in the address would change at every frame.
    if (!(clock.playing && changes.size === 1 && changes.has('time')))
      writeSoon(lab, host, address);
  });

  /** The motion that Reset goes back to: that of the link, the case or the lesson. */
  let origin = first.problem;
  const read = (fragment: string): void => {
    clock.pause();
    const { asked, pin, rest } = partsOf(fragment);
    const link = asked !== null && rest === '' ? asked.lesson.link : rest;
    const { state, fieldErrors } = parse(link, lab.state);
    if (asked?.text !== ask.asked?.text) openQuestion(asked);
    reading = true;
    if (pin !== null || asked === null) fieldErrors.push(...pinned(pin));
    lab.take(state.problem, state.view, fieldErrors);
    reading = false;
    address.taken();
    showLinkErrors(lab.fieldErrors);
  };
  /** Pins the motion of a link, if there is one; what is wrong with it. */
  const pinned = (link: string | null): FieldError[] => {
    const { state, fieldErrors } = link === null ? { state: null, fieldErrors: [] } : parse(link);
    const errors = [...fieldErrors, ...lab.pin(state?.problem ?? null)];
    return errors.map((it) => ({ ...it, field: `pin: ${it.field}` }));
  };
  /** The question of a lesson, and the motion that is pinned for it. */
  const openQuestion = (asked: Asked | null): void => {
    ask.open(asked);
    // A lesson begins with the simple view.
    lab.setView({});
    const pin = asked?.lesson.pin;
    lab.pin(pin === undefined ? null : parse(pin).state.problem);
  };
  const openLesson = (asked: Asked | null): void => {
    clock.pause();
    openQuestion(asked);
    if (asked === null) return;
    const { problem } = parse(asked.lesson.link).state;
    lab.take(problem, { rate: rateOf(problem) });
    origin = problem;
  };
  byId('reset', HTMLButtonElement).addEventListener('click', () => {
    clock.pause();
    lab.take(origin);
  });
  const host = new Host((fragment) => {
    if (fragment.replace(/^#/, '') !== format(lab.state)) {
      read(fragment);
      origin = lab.state.problem;
    }
  });
  const other = otherLanguage();
  const languageLink = byId('language', HTMLAnchorElement);
  languageLink.textContent = other.name;
  languageLink.lang = other.language;
  // A notebook's page has no address to change.
  languageLink.hidden = !HAS_ADDRESS;
  // The motion comes along.
  languageLink.addEventListener('click', (event) => {
    event.preventDefault();
    location.assign(`${other.address}#${address.fragment}`);
  });
  byId('theme', HTMLButtonElement).addEventListener('click', () => {
    lab.setView({ theme: isDark(lab.state.view.theme) ? 'light' : 'dark' });
  });
  onSystemTheme(showTheme);
  byId('skip', HTMLAnchorElement).addEventListener('click', (event) => {
    // The part after # is the state, not a place on the page.
    event.preventDefault();
    const target = level.isSimple ? hoop.weight : byId('start-handle', HTMLButtonElement);
    target.focus();
  });
  window.addEventListener('beforeprint', () => {
    byId('sheet-link', HTMLParagraphElement).textContent = address.text;
    paintPlots(true);
  });
  window.addEventListener('hashchange', () => {
    if (location.hash.slice(1) !== address.fragment) read(location.hash);
  });
  ask.open(null);
  lab.announce();
  if (location.hash.length > 1) read(location.hash);
  else level.first();
  origin = lab.state.problem;
  host.ready(HAS_ADDRESS ? format(lab.state) : null);
  document.documentElement.dataset.ready = 'true';
  performance.mark('ready');
  if (HAS_ADDRESS && 'serviceWorker' in navigator && import.meta.env.PROD)
    void navigator.serviceWorker.register('./sw.js').catch(() => {
      // Without it the page needs the network; that is all.
    });
}

let timer = 0;
function writeSoon(lab: Lab, host: Host, address: Address): void {
  window.clearTimeout(timer);
  // A link that is wrong stays in sight, to be mended.
  if (lab.fieldErrors.length > 0) return;
  const shown = location.hash;
  timer = window.setTimeout(() => {
    // Another address that has come meanwhile, as by going back, is yet to be read.
    if (location.hash === shown) address.write();
    host.tell(format(lab.state));
  }, ADDRESS_PAUSE);
}

/** What is wrong in a link is shown at the top, too: its field may be out of sight, or there may be none. */
function showLinkErrors(fieldErrors: readonly FieldError[]): void {
  const banner = byId('banner', HTMLParagraphElement);
  banner.hidden = fieldErrors.length === 0;
  const list = fieldErrors.map((it) => `${it.field}=${it.given}: ${it.message}`).join('; ');
  banner.textContent = banner.hidden ? '' : `Invalid link: ${list}.`;
}
