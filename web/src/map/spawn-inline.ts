// The worker of the map as a part of the page.

import MapWorker from './worker?worker&inline';

export function spawn(): Worker {
  return new MapWorker();
}
