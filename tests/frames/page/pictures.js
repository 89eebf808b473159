// The decoded pictures that the page holds: those that were needed last, within a budget. They are
// bitmaps, which the page frees itself. Of every <img> the browser keeps what it has decoded: half a
// gigabyte in a long film.
"use strict";

class Pictures {
  static most = 40;
  static mostPixels = 25e6;  // 100 MB, as a decoded pixel has four bytes

  #held = new Map();  // { bitmap, users } by address; what was needed last is last
  #largest = 1;       // pixels of the largest picture so far

  // How many pictures fit at once.
  get room() {
    return Math.max(2, Math.min(Pictures.most, Math.floor(Pictures.mostPixels / this.#largest)));
  }

  get count() {
    return this.#held.size;
  }

  // Decodes a picture that may be needed soon.
  prepare(address) {
    this.#hold(address);
    this.#free();
  }

  // Calls draw(bitmaps) as soon as all pictures are decoded. A bitmap is null if its address is, or if
  // its picture is missing or broken.
  async use(addresses, draw) {
    const held = addresses.map((address) =>
      (address === null ? { bitmap: null } : this.#hold(address)));
    for (const picture of held) ++picture.users;
    draw(await Promise.all(held.map((picture) => picture.bitmap)));
    for (const picture of held) --picture.users;
    this.#free();
  }

  #hold(address) {
    const held = this.#held.get(address) ?? { bitmap: this.#decode(address), users: 0 };
    this.#held.delete(address);
    this.#held.set(address, held);
    return held;
  }

  async #decode(address) {
    const image = new Image();
    try {
      await new Promise((onload, onerror) => {
        Object.assign(image, { onload, onerror, src: address });
      });
      this.#largest = Math.max(this.#largest, image.naturalWidth * image.naturalHeight);
      return await createImageBitmap(image);
    } catch {
      return null;
    }
  }

  // Frees what was not needed for the longest time, but nothing that is going to be drawn.
  #free() {
    for (const [address, { bitmap, users }] of this.#held) {
      if (this.#held.size <= this.room) return;
      if (users > 0) continue;
      this.#held.delete(address);
      bitmap.then((decoded) => decoded?.close());
    }
  }
}
