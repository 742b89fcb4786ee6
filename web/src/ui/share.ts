// The dialogue for links, commands, data and pictures.

import { byId } from '../dom';
import type { Palette } from '../generated/palette';
import type { Lab } from '../state/lab';
import { pythonLine, shellLine } from './commands';
import {
  filmOf,
  type Painter,
  type PainterAt,
  painterOfPlots,
  pngOf,
  save,
  svgOf,
  type View,
} from './export';
import { TEXTS } from './texts';

/** The motion at an address as a frame for another page. */
function frameOf(address: string): string {
  const source = `${address}&embed=1`.replaceAll('&', '&amp;');
  return `<iframe src="${source}" title="Littlewood’s hoop" width="640" height="420" style="border: 0" allow="clipboard-write"></iframe>`;
}

/** What a page needs to have that frame: the hosts of a server for one's own machine are no address for others. */
function frameNote(): string {
  const { protocol, hostname, host } = location;
  const isOnWeb = protocol === 'https:' || protocol === 'http:';
  if (isOnWeb && !['127.0.0.1', 'localhost', '[::1]'].includes(hostname))
    return `Any page may have this frame; one with a content security policy must name ${host} in its frame-src.`;
  const onWeb =
    'For a page on the web, put the folder web/dist on a static host and take the frame there.';
  return isOnWeb
    ? `This address is of your machine: the frame works in pages served from it, as http://localhost, while this server runs. ${onWeb}`
    : `This page has no address for a frame. ${onWeb}`;
}

const VIEWS: readonly View[] = ['hoop', 'plane', 'plots', 'impact'];

export class Share {
  private readonly dialog = byId('share', HTMLDialogElement);
  private readonly samples = byId('samples', HTMLInputElement);
  private readonly note = byId('toast', HTMLParagraphElement);
  private timer = 0;

  constructor(
    private readonly lab: Lab,
    private readonly painters: Record<Exclude<View, 'plots'>, Painter> & { film: PainterAt },
    private readonly palette: () => Palette,
    private readonly address: () => string,
  ) {
    byId('open-share', HTMLButtonElement).addEventListener('click', () => this.open());
    byId('copy-link', HTMLButtonElement).addEventListener('click', () => void this.shareLink());
    byId('close-share', HTMLButtonElement).addEventListener('click', () => this.dialog.close());
    for (const id of ['link', 'frame', 'shell', 'python', 'own']) {
      const field = byId(`${id}-text`, HTMLTextAreaElement);
      byId(`copy-${id}-text`, HTMLButtonElement).addEventListener(
        'click',
        () => void this.copy(field.value, field),
      );
    }
    byId('save-csv', HTMLButtonElement).addEventListener('click', () => this.data('csv'));
    byId('save-json', HTMLButtonElement).addEventListener('click', () => this.data('json'));
    for (const view of VIEWS) {
      byId(`svg-${view}`, HTMLButtonElement).addEventListener(
        'click',
        () => void this.picture(view, 'svg'),
      );
      byId(`png-${view}`, HTMLButtonElement).addEventListener(
        'click',
        () => void this.picture(view, 'png'),
      );
    }
    for (const format of ['gif', 'mp4'] as const)
      byId(`${format}-hoop`, HTMLButtonElement).addEventListener(
        'click',
        () => void this.film(format),
      );
    this.samples.addEventListener('input', () => this.count());
  }

  private open(): void {
    byId('link-text', HTMLTextAreaElement).value = this.address();
    byId('frame-text', HTMLTextAreaElement).value = frameOf(this.address());
    byId('frame-note', HTMLParagraphElement).textContent = frameNote();
    byId('shell-text', HTMLTextAreaElement).value = shellLine(this.lab.state.problem);
    byId('python-text', HTMLTextAreaElement).value = pythonLine(this.lab.state.problem);
    const { impact, motion } = this.lab;
    byId('picture-impact', HTMLSpanElement).hidden =
      impact === null || motion.routh(impact) === null;
    this.dialog.showModal();
  }

  /** The system's own way to share where there is one that is meant for fingers; else the clipboard. */
  private async shareLink(): Promise<void> {
    const url = this.address();
    if (matchMedia('(pointer: coarse)').matches && 'share' in navigator) {
      try {
        await navigator.share({ title: document.title, url });
        return;
      } catch {
        // Not wanted, or not possible: the clipboard is left.
      }
    }
    await this.copy(url, null);
  }

  private async copy(text: string, field: HTMLTextAreaElement | null): Promise<void> {
    try {
      await navigator.clipboard.writeText(text);
      this.notify(TEXTS.page.copied);
    } catch {
      if (!field) {
        this.open();
        byId('link-text', HTMLTextAreaElement).select();
      } else {
        field.select();
      }
      this.notify(TEXTS.page.not_copied);
    }
  }

  private notify(text: string): void {
    window.clearTimeout(this.timer);
    // The dialogue lies over all that is not in it.
    (this.dialog.open ? this.dialog : document.body).append(this.note);
    this.note.textContent = text;
    this.note.classList.add('shown');
    this.timer = window.setTimeout(() => {
      this.note.classList.remove('shown');
      this.note.textContent = '';
    }, 2500);
  }

  /** Number of samples that is asked for; none for transitions only; undefined where the field makes no sense. */
  private count(): number | null | undefined {
    const text = this.samples.value.trim();
    const message = byId('samples-message', HTMLSpanElement);
    const count = Number(text);
    const wrong = text !== '' && !(Number.isInteger(count) && count >= 2 && count <= 1_000_000);
    message.textContent = wrong ? 'a whole number from 2 to 1000000, or empty' : '';
    this.samples.setAttribute('aria-invalid', String(wrong));
    if (wrong) return undefined;
    return text === '' ? null : count;
  }

  private get name(): string {
    return this.lab.named ?? 'hoop';
  }

  private data(format: 'csv' | 'json'): void {
    const count = this.count();
    if (count === undefined) {
      this.samples.focus();
      return;
    }
    const { motion } = this.lab;
    const text =
      format === 'csv' ? motion.csv(count ?? undefined) : motion.json(count ?? undefined);
    save(
      `${this.name}.${format}`,
      new Blob([text], { type: format === 'csv' ? 'text/csv' : 'application/json' }),
    );
  }

  private async picture(view: View, format: 'svg' | 'png'): Promise<void> {
    const palette = this.palette();
    const painter = view === 'plots' ? painterOfPlots(this.lab, palette) : this.painters[view];
    try {
      const content =
        format === 'svg'
          ? new Blob([svgOf(view, painter, palette)], { type: 'image/svg+xml' })
          : await pngOf(view, painter, palette);
      save(`${this.name}-${view}.${format}`, content);
    } catch (error) {
      this.notify(`The picture could not be made: ${String(error)}`);
    }
  }

  /** Makes a film, and says how far it is. */
  private async film(format: 'gif' | 'mp4'): Promise<void> {
    const buttons = (['gif', 'mp4'] as const).map((it) => byId(`${it}-hoop`, HTMLButtonElement));
    const said = byId('film-progress', HTMLOutputElement);
    const progress = (part: number): void => {
      said.textContent = `${Math.round(100 * part)} %`;
    };
    for (const button of buttons) button.disabled = true;
    try {
      const { lab, painters } = this;
      const film = await filmOf(format, lab, painters.film, this.palette(), progress);
      save(`${this.name}.${format}`, film);
      said.textContent = `${this.name}.${format}, ${Math.ceil(film.size / 1000)} kB`;
    } catch (error) {
      said.textContent = `No film: ${error instanceof Error ? error.message : String(error)}.`;
    } finally {
      for (const button of buttons) button.disabled = false;
    }
  }
}
