// SPDX-License-Identifier: BSD-2-Clause
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.util.Arrays;
import java.util.Comparator;
import java.util.Objects;
import java.util.function.Consumer;
import java.util.function.Supplier;

/** A minimal test framework for the tests of this folder. */
final class Check {
  interface Action {
    void run() throws Exception;
  }

  private Check() {}

  static void that(boolean is, String what) {
    if (!is) throw new AssertionError(what);
  }

  static void equal(Object actual, Object expected) {
    that(Objects.equals(actual, expected), "\n  expected: " + expected + "\n  is:       " + actual);
  }

  static void contains(String text, String part) {
    that(text.contains(part), "\n  expected: ... " + part + " ...\n  is:       " + text);
  }

  /** Expects the action to throw an exception of this class or a subclass. Returns its message. */
  static String fails(Class<? extends Throwable> type, Action action) {
    try {
      action.run();
    } catch (Throwable problem) {
      that(type.isInstance(problem), "expected " + type.getName() + ", is " + problem);
      return String.valueOf(problem.getMessage());
    }
    throw new AssertionError("expected " + type.getName() + ", but nothing failed");
  }

  /** Runs all methods with names that begin with "test", each with a new object. Returns the number of failed ones. */
  static <T> int runAll(Class<T> type, Supplier<T> make, Consumer<T> end) throws Exception {
    Method[] methods = type.getMethods();
    Arrays.sort(methods, Comparator.comparing(Method::getName));
    int failed = 0;
    int made = 0;
    for (Method method : methods) {
      if (!method.getName().startsWith("test")) continue;
      ++made;
      T object = make.get();
      try {
        method.invoke(object);
        System.out.println("ok      " + method.getName());
      } catch (InvocationTargetException problem) {
        ++failed;
        System.out.println("FAILED  " + method.getName());
        problem.getCause().printStackTrace(System.out);
      }
      end.accept(object);
    }
    that(made > 0, "there are no tests in " + type.getName());
    System.out.println(made + " tests, " + failed + " failed");
    return failed;
  }
}
