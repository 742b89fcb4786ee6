// The laboratory in a notebook: the module for anywidget, in a page that stands for the notebook.

import { existsSync, readFileSync } from 'node:fs';
import { expect, type FrameLocator, type Page, test } from '@playwright/test';

const MODULE = new URL('../../python/littlewood/lab/laboratory.js', import.meta.url);

/**
 * A notebook with one cell: a model with a link and a height, and the widget of it, which hears
 * messages at once, or from `hear()` on.
 */
async function notebook(page: Page, link: string, deaf = false): Promise<FrameLocator> {
  expect(existsSync(MODULE), 'web/build.sh makes the module').toBe(true);
  const errors: string[] = [];
  page.on('pageerror', (error) => {
    if (!error.message.startsWith('ResizeObserver loop')) throw error;
  });
  page.on('console', (message) => {
    if (message.type() === 'error') errors.push(message.text());
  });
  // No request at all: there is no network where the notebook is.
  await page.route('**', (route) => {
    const { pathname } = new URL(route.request().url());
    if (pathname === '/notebook')
      return route.fulfill({
        contentType: 'text/html',
        body: '<!doctype html><title>cell</title><div id="cell"></div>',
      });
    if (pathname === '/module.js')
      return route.fulfill({ contentType: 'text/javascript', body: readFileSync(MODULE, 'utf8') });
    throw new Error(`a request to ${route.request().url()}`);
  });
  await page.goto('http://127.0.0.1:1/notebook');
  await page.evaluate(
    async ({ link, deaf }) => {
      // What a slow notebook has not heard yet waits, in its order.
      const listen = window.addEventListener.bind(window);
      let waiting: (() => void)[] | undefined = [];
      const late = (type: string, listener: (event: Event) => void): void =>
        listen(type, (event) => {
          if (waiting) waiting.push(() => listener(event));
          else listener(event);
        });
      const hear = (): void => {
        const heard = waiting ?? [];
        waiting = undefined;
        for (const listener of heard) listener();
      };
      if (deaf) Object.assign(window, { addEventListener: late, hear });
      const listeners = new Map<string, () => void>();
      const traits: Record<string, unknown> = { link, height: 700 };
      const model = {
        get: (name: string) => traits[name],
        set: (name: string, value: unknown) => {
          traits[name] = value;
          listeners.get(`change:${name}`)?.();
        },
        save_changes: () => undefined,
        on: (name: string, listener: () => void) => listeners.set(name, listener),
        off: (name: string) => listeners.delete(name),
      };
      Object.assign(window, { model });
      const { default: widget } = (await import('/module.js' as string)) as {
        default: { render(it: object): () => void };
      };
      Object.assign(window, {
        close: widget.render({ model, el: document.querySelector('#cell') }),
      });
    },
    { link, deaf },
  );
  const frame = page.frameLocator('iframe');
  await expect(frame.locator('html[data-ready=true]')).toBeAttached();
  return frame;
}

const linkOf = (page: Page): Promise<string> => page.evaluate('model.get("link")');

test('the widget shows the link of its model, and the model has the state of the widget', async ({
  page,
}) => {
  const frame = await notebook(page, 'case=figure-3&at=1.2');
  await expect(frame.locator('#now')).toHaveText('τ = 1.200');
  await expect(frame.locator('html[data-map=done]')).toBeAttached();
  await frame.locator('#field-mu_k').fill('0.37');
  await expect.poll(() => linkOf(page)).toMatch(/mu_k=0\.37/);
  await page.evaluate('model.set("link", "case=rolls-forever&at=2")');
  await expect(frame.locator('#case')).toHaveValue('rolls-forever');
  await expect(frame.locator('#now')).toHaveText('τ = 2.000');
  await page.evaluate('model.set("height", 500)');
  expect((await page.locator('iframe').boundingBox())!.height).toBe(500);
});

for (const deaf of [false, true]) {
  const notebookHears = deaf ? 'after the guest has moved' : 'at once';
  test(`the motion of the model is kept where the notebook hears ${notebookHears}`, async ({
    page,
  }) => {
    const link = 'case=figure-7&at=0.7';
    const frame = await notebook(page, link, deaf);
    if (deaf) {
      // A guest who is faster than the host changes nothing of the model's, either.
      await frame.locator('#time').press('End');
      await page.waitForTimeout(500);
      await page.evaluate('hear()');
    }
    await expect(frame.locator('#case')).toHaveValue('figure-7');
    await expect(frame.locator('#now')).toHaveText('τ = 0.700');
    await page.waitForTimeout(500);
    expect(await linkOf(page)).toBe(link);
    // From then on both sides tell each other.
    await frame.locator('#time').press('Home');
    await expect.poll(() => linkOf(page)).toBe('case=figure-7');
  });
}

test('what a frame of another page says is not for the model', async ({ page }) => {
  await notebook(page, 'case=figure-3');
  await page.evaluate('window.postMessage({ littlewood: { link: "case=figure-7" } }, "*")');
  await page.waitForTimeout(100);
  expect(await linkOf(page)).toBe('case=figure-3');
});

test('pictures are made in a notebook, too', async ({ page }) => {
  const frame = await notebook(page, 'case=figure-3');
  await frame.locator('#open-share').click();
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    frame.locator('#svg-hoop').click(),
  ]);
  expect(download.suggestedFilename()).toBe('figure-3-hoop.svg');
});
