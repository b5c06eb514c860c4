// SPDX-License-Identifier: BSD-2-Clause
package sml;

import java.lang.ref.Cleaner;

/** The numbers that identify the library's objects. Objects of this package contain them instead of pointers. */
final class Handles {
  private static final Cleaner CLEANER = Cleaner.create();

  private Handles() {}

  /** Releases the number when the object is no longer reachable. */
  static void watch(Object object, long handle) {
    CLEANER.register(object, new Releaser(handle));
  }

  /** Releases the number. May be called more than once. */
  static void release(long handle) {
    smlJNI.release(handle);
  }

  /** Returns an element of the class that its number specifies; null for 0. */
  static WMElement element(long handle) {
    if (handle == 0) return null;
    switch ((int) (handle & 7)) {
      case 1: return new StringElement(handle, true);
      case 2: return new IntElement(handle, true);
      case 3: return new FloatElement(handle, true);
      case 4: return new Identifier(handle, true);
      default: return new WMElement(handle, true);
    }
  }

  private static final class Releaser implements Runnable {
    private final long handle;

    Releaser(long handle) {
      this.handle = handle;
    }

    @Override
    public void run() {
      release(handle);
    }
  }
}
