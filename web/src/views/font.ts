// The font of what is drawn.

export const FONT = 'system-ui, "Segoe UI", Roboto, "DejaVu Sans", sans-serif';
