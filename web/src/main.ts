// The laboratory: puts the parts together.

import './generated/palette.css';
import './style/theme.css';
import './style/base.css';
import './style/page.css';
import './style/panes.css';
import './style/dialogue.css';
import './style/screens.css';
import { namesAgree } from './core/motion';
import { cases as casesOfCore, load, provokePanic } from './core/wasm';
import { Lab, type Change } from './state/lab';
import { casesOf, problemOfCase, VIEW, type NamedCase, type State, type Theme } from './state/state';
import { format, parse, type FieldError } from './state/url';
import { Clock } from './ui/clock';
import { showDefect, watch } from './ui/defect';
import { byId } from './dom';
import { EnergyBar } from './ui/energy-bar';
import { EventTable } from './ui/event-table';
import { Fields } from './ui/fields';
import { HoopPane } from './ui/hoop-pane';
import { ImpactPane } from './ui/impact-pane';
import { PlanePane } from './ui/plane-pane';
import { ProblemBar } from './ui/problem-bar';
import { Share } from './ui/share';
import { Story } from './ui/story';
import { isDark, onSystemTheme, paletteOf, setTheme } from './ui/theme';
import { Transport } from './ui/transport';
import { Plots } from './views/plots';

/** How long the address waits, so that a drag does not write it at every step. */
const ADDRESS_PAUSE = 250;

watch();
await load(showDefect);
if (!namesAgree()) throw new Error('the page and its core are of different versions');
start(casesOf(casesOfCore()));

function start(cases: NamedCase[]): void {
  if (location.hash === '#panic') provokePanic();
  const first: State = { problem: problemOfCase(cases[0]!), view: { ...VIEW } };
  const lab = new Lab(first, cases);
  setTheme(first.view.theme);

  let palette = paletteOf(first.view.theme);
  let frame = 0;
  const draw = (): void => {
    if (frame === 0) frame = requestAnimationFrame(paint);
  };
  const clock = new Clock(lab, () => transport.showView());
  const go = (time: number): void => {
    clock.pause();
    lab.setTime(time);
  };
  const hoop = new HoopPane(lab, palette, draw);
  const plane = new PlanePane(lab, palette, draw, showDefect);
  const plots = new Plots(byId('plots', HTMLDivElement), palette, go);
  const fields = new Fields(byId('fields', HTMLDivElement), lab);
  const bar = new ProblemBar(lab, () => clock.pause());
  const transport = new Transport(lab, clock);
  const story = new Story(lab);
  const events = new EventTable(lab, go);
  const energy = new EnergyBar(lab);
  const impact = new ImpactPane(lab, palette, draw, go);
  new Share(lab, {
    hoop: (c, width, height) => hoop.drawOn(c, width, height),
    plane: (c, width, height) => plane.drawOn(c, width, height),
    impact: (c, width, height) => impact.drawOn(c, width, height),
  }, () => palette, () => address(lab));

  const stale = { motion: true, time: true };
  function paint(): void {
    frame = 0;
    if (stale.motion) plots.setMotion({ motion: lab.motion, units: lab.units, system: lab.state.problem.system });
    if (stale.motion || stale.time) plots.setTime(lab.time);
    stale.motion = false;
    stale.time = false;
    plane.paint();
    hoop.paint();
    impact.paint();
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

  lab.onChange((changes: ReadonlySet<Change>) => {
    if (changes.has('motion')) {
      stale.motion = true;
      transport.showMotion();
      story.showMotion();
      events.showMotion();
      energy.showMotion();
      impact.showMotion();
      bar.show();
    }
    if (changes.has('errors')) {
      fields.show();
      bar.show();
      if (!reading) showLinkErrors([]);
    }
    if (changes.has('view')) {
      transport.showView();
      hoop.viewChanged();
      plane.viewChanged();
      if (lab.state.view.theme !== theme) {
        theme = lab.state.view.theme;
        showTheme();
      }
    }
    if (changes.has('hoop')) plane.hoopChanged();
    if (changes.has('time')) {
      stale.time = true;
      transport.showTime();
      story.showTime();
      events.showTime();
      energy.showTime();
      impact.showTime();
    }
    plane.motionChanged();
    draw();
    // While it plays, the time in the address would change at every frame.
    if (!(clock.playing && changes.size === 1 && changes.has('time'))) writeSoon(lab);
  });

  const read = (): void => {
    clock.pause();
    const { state, fieldErrors } = parse(location.hash, lab.state, cases);
    reading = true;
    lab.take(state.problem, state.view, fieldErrors);
    reading = false;
    showLinkErrors(lab.fieldErrors);
  };
  byId('theme', HTMLButtonElement).addEventListener('click', () => {
    lab.setView({ theme: isDark(lab.state.view.theme) ? 'light' : 'dark' });
  });
  onSystemTheme(showTheme);
  byId('skip', HTMLAnchorElement).addEventListener('click', (event) => {
    // The part after # is the state, not a place on the page.
    event.preventDefault();
    byId('start-handle', HTMLButtonElement).focus();
  });
  window.addEventListener('hashchange', () => {
    if (location.hash.slice(1) !== format(lab.state, cases)) read();
  });
  lab.announce();
  if (location.hash.length > 1) read();
  document.documentElement.dataset['ready'] = 'true';
  performance.mark('ready');
  if ('serviceWorker' in navigator && import.meta.env.PROD) void navigator.serviceWorker.register('./sw.js').catch(() => {
    // Without it the page needs the network; that is all.
  });
}

function address(lab: Lab): string {
  return `${location.origin}${location.pathname}${location.search}#${format(lab.state, lab.cases)}`;
}

let timer = 0;
function writeSoon(lab: Lab): void {
  window.clearTimeout(timer);
  // A link that is wrong stays in sight, to be mended.
  if (lab.fieldErrors.length > 0) return;
  const shown = location.hash;
  timer = window.setTimeout(() => {
    // Another address that has come meanwhile, as by going back, is yet to be read.
    if (location.hash === shown) history.replaceState(null, '', address(lab));
  }, ADDRESS_PAUSE);
}

/** What is wrong in a link is shown at the top, too: its field may be out of sight, or there may be none. */
function showLinkErrors(fieldErrors: readonly FieldError[]): void {
  const banner = byId('banner', HTMLParagraphElement);
  banner.hidden = fieldErrors.length === 0;
  const list = fieldErrors.map((it) => `${it.field}=${it.given}: ${it.message}`).join('; ');
  banner.textContent = banner.hidden ? '' : `The link cannot be shown as it is. ${list}.`;
}
