// Everything without a mouse.

import { expect, test } from '@playwright/test';
import { field, open, phases } from './lab';

test('the start moves with the arrow keys', async ({ page }) => {
  await open(page, 'case=rolls-forever');
  // The first stop of the tabulator leads straight to the start.
  await page.keyboard.press('Tab');
  await expect(page.locator('.skip')).toBeFocused();
  await page.keyboard.press('Enter');
  await expect(page.locator('#start-handle')).toBeFocused();
  await expect(page.locator('#banner')).toBeHidden();
  for (let i = 0; i < 30; i++) await page.keyboard.press('ArrowUp');
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('Shift+ArrowLeft');
  await expect(field(page, 'theta')).toHaveValue('0.045');
  await expect(field(page, 'theta_rate')).toHaveValue('2');
  expect((await phases(page))[0]!.mode).toBe('flight');
  await expect(page.locator('#start-handle')).toHaveAttribute('aria-label', /θ = 0\.045, θ′ = 2\./);
});

test('every control can be reached and used', async ({ page }) => {
  await open(page, 'case=figure-3');
  const wanted = [
    'case',
    'copy-link',
    'open-share',
    'theme',
    'si',
    'massless',
    'field-mu_s',
    'slider-mu_s',
    'bounces',
    'material',
    'field-restitution',
    'field-gap_rate',
    'level',
    'reset',
    'pin',
    'follow',
    'slope-handle',
    'map',
    'shows',
    'zoom-in',
    'zoom-out',
    'start-handle',
    'play',
    'next',
    'time',
    'speed',
    'loop',
  ];
  const reached = new Set<string>();
  for (let i = 0; i < 120 && wanted.some((id) => !reached.has(id)); i++) {
    await page.keyboard.press('Tab');
    reached.add(await page.evaluate(() => document.activeElement?.id ?? ''));
  }
  expect(wanted.filter((id) => !reached.has(id))).toEqual([]);

  await page.locator('#case').focus();
  await page.keyboard.type('slip');
  await expect(page.locator('#case')).toHaveValue('slip-then-jump');
  await field(page, 'mu_s').focus();
  await page.keyboard.press('ArrowUp');
  await expect(field(page, 'mu_s')).toHaveValue('0.51');
  await page.locator('#slider-mu_s').focus();
  await page.keyboard.press('ArrowLeft');
  await expect(field(page, 'mu_s')).toHaveValue('0.5');
  await page.locator('#time').focus();
  await page.keyboard.press('End');
  await expect(page.locator('#sentence')).toContainText('Lands');
  await page.keyboard.press('Home');
  await page.keyboard.press('Space');
  await expect(page.locator('#play')).toHaveAttribute('data-state', 'playing');
  await page.keyboard.press('Space');
  await page.locator('#open-share').focus();
  await page.keyboard.press('Enter');
  await expect(page.locator('#share')).toBeVisible();
  await page.keyboard.press('Escape');
  await expect(page.locator('#share')).toBeHidden();
  await expect(page.locator('#open-share')).toBeFocused();
});

test('a change of mode is told to a reader of the screen', async ({ page }) => {
  await open(page, 'case=figure-3');
  const live = page.locator('[aria-live=polite]');
  await expect(live).toContainText('Slips');
  await page.locator('#next').focus();
  await page.keyboard.press('Enter');
  await expect(live).toContainText('rolling');
  await expect(page.locator('#time')).toHaveAttribute(
    'aria-valuetext',
    /τ = 0\.564 of 3\.847, rolling/,
  );
});
