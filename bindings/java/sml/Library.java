// SPDX-License-Identifier: BSD-2-Clause
package sml;

import java.io.File;
import java.net.URISyntaxException;
import java.security.CodeSource;

/** Loads the library, and shuts it down when the program ends. */
final class Library {
  private static final String NAME = "Java_sml_ClientInterface";
  /** Maximum time for the shutdown of kernels at the end of the program, in milliseconds. */
  private static final long PATIENCE = 2000;

  private Library() {}

  /** Loads the library: from java.library.path, the folder of sml.jar, or a folder above it. */
  static void load() {
    find();
    Runtime.getRuntime().addShutdownHook(new Thread(Library::end, "sml: shutdown"));
  }

  private static void find() {
    UnsatisfiedLinkError missing;
    try {
      System.loadLibrary(NAME);
      return;
    } catch (UnsatisfiedLinkError error) {
      missing = error;
    }
    File folder = folder();
    for (int up = 0; folder != null && up < 2; ++up) {
      File file = new File(folder, System.mapLibraryName(NAME));
      if (file.isFile()) {
        System.load(file.getAbsolutePath());
        return;
      }
      folder = folder.getParentFile();
    }
    throw missing;
  }

  private static File folder() {
    CodeSource source = Library.class.getProtectionDomain().getCodeSource();
    if (source == null || source.getLocation() == null) return null;
    try {
      return new File(source.getLocation().toURI()).getAbsoluteFile().getParentFile();
    } catch (URISyntaxException | IllegalArgumentException notInFile) {
      return null;
    }
  }

  /** If a handler ends the program, its kernel cannot shut down and is abandoned. */
  private static void end() {
    Thread ending = new Thread(smlJNI::endKernels, "sml: kernels shut down");
    ending.setDaemon(true);
    ending.start();
    try {
      ending.join(PATIENCE);
    } catch (InterruptedException interrupted) {
      Thread.currentThread().interrupt();
    }
    smlJNI.shutDoor();
  }
}
