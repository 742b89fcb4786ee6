// The page around this one, where this one is a frame: it is told of every new link, and may ask
// for one.
//
// A message is `{ littlewood: { link: 'case=figure-3&at=1.2' } }` both ways, the link without `#`.
// The first one says that the page is ready. What the page is opened with is no news; without an
// address it is opened with nothing, and tells of nothing until it has shown the first link of its
// host, however late that comes.

/** Reads a message; none if it is not for us. */
function linkOf(data: unknown): string | null {
  if (typeof data !== 'object' || data === null || !('littlewood' in data)) return null;
  const { littlewood } = data;
  if (typeof littlewood !== 'object' || littlewood === null || !('link' in littlewood)) return null;
  return typeof littlewood.link === 'string' ? littlewood.link : null;
}

export class Host {
  /** The link that both sides know; none before there is one. */
  private told: string | null = null;

  constructor(show: (link: string) => void) {
    if (window.parent === window) return;
    window.addEventListener('message', ({ data, source }) => {
      const link = source === window.parent ? linkOf(data) : null;
      if (link === null) return;
      this.told = link;
      show(link);
    });
  }

  /** Says that messages are read from now on; `opened` is the link of the address, if there is one. */
  ready(opened: string | null): void {
    this.told = opened;
    this.post({ ready: true });
  }

  /** Tells of the state, unless it is what has been asked for, or told, last. */
  tell(link: string): void {
    if (this.told === null || link === this.told) return;
    this.told = link;
    this.post({ link });
  }

  private post(littlewood: { ready: true } | { link: string }): void {
    // A motion is no secret: whatever page has put this one into a frame may know which is shown.
    if (window.parent !== window) window.parent.postMessage({ littlewood }, '*');
  }
}
