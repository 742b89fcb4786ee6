// Mode and sentence of the current event.

import { type Event, modeOf } from '../core/motion';
import { byId } from '../dom';
import type { Lab } from '../state/lab';
import { filled, TEXTS } from './texts';

export class Story {
  private readonly mode = byId('mode', HTMLSpanElement);
  private readonly sentence = byId('sentence', HTMLSpanElement);
  /** Of the instant: not a part of what is read aloud at each event. */
  private readonly friction = byId('friction', HTMLParagraphElement);
  private readonly numbers = byId('numbers', HTMLDetailsElement);
  private readonly numberText = byId('number-text', HTMLParagraphElement);
  /** The event whose sentence is shown. */
  private shown: Event | null = null;

  constructor(private readonly lab: Lab) {}

  showMotion(): void {
    this.shown = null;
    this.showTime();
  }

  /** Numbers that only explain are folded away. */
  private say(text: string, hasNumbers: boolean): void {
    const [, head, numbers] = hasNumbers ? (/^(.*?): (.*)$/.exec(text) ?? []) : [];
    this.sentence.textContent = head === undefined ? text : `${head}.`;
    this.numbers.hidden = numbers === undefined;
    this.numberText.textContent = numbers ?? '';
  }

  showTime(): void {
    const { motion, time } = this.lab;
    this.friction.textContent = TEXTS.events === undefined ? motion.friction(time) : '';
    const event = motion.eventAt(time);
    if (event === this.shown) return;
    this.shown = event;
    const sample = motion.at(time);
    const mode = event.to ?? (sample === null ? null : modeOf(sample.mode));
    const { no_motion, ends } = TEXTS.page;
    // The library has English sentences, with numbers; a translation has some of its own.
    const name = mode === null ? no_motion : TEXTS.events === undefined ? mode : TEXTS.modes[mode];
    this.mode.textContent =
      mode !== null && event.to === null ? filled(ends, { mode: name }) : name;
    if (mode === null) delete this.mode.dataset.mode;
    else this.mode.dataset.mode = mode;
    const said = TEXTS.events?.[event.name];
    if (said !== undefined) this.say(said, false);
    else
      this.say(
        motion.sentencesAt(time).join(' '),
        event.name === 'inconsistent' || event.name === 'ambiguous',
      );
  }
}
