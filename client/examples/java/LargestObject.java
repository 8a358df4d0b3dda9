// SPDX-License-Identifier: BSD-3-Clause
// In Java, with JNA: prints the largest object of every frame, as 01_print_segments.cpp does, and
// the point of it that is nearest to the camera, read where the camera's grabber wrote it.
//
//     apt-get install openjdk-17-jdk-headless libjna-java
//     LD_LIBRARY_PATH=build/release/lib java -cp /usr/share/java/jna.jar client/examples/java/LargestObject.java [SENSOR [FRAMES]]
import com.sun.jna.Library;
import com.sun.jna.Native;
import com.sun.jna.NativeLong;
import com.sun.jna.Pointer;
import com.sun.jna.Structure;
import com.sun.jna.ptr.NativeLongByReference;
import com.sun.jna.ptr.PointerByReference;
import java.nio.FloatBuffer;
import java.nio.ShortBuffer;
import java.util.Locale;

public class LargestObject {
  /** Of cleave.h what is needed here. */
  public interface C extends Library {
    int ABI_VERSION = 1, OK = 0, FAILED = 5;
    C cleave = Native.load("cleave-c", C.class);

    int cleave_abi_version();
    String cleave_error();
    int cleave_open(Pointer options, PointerByReference stream);
    void cleave_close(Pointer stream);
    int cleave_frames_open(Pointer stream, String sensor, PointerByReference frames);
    void cleave_frames_close(Pointer frames);
    int cleave_frames_next(Pointer frames, int timeoutMs, PointerByReference cloud,
        PointerByReference labels, PointerByReference segments);
    void cleave_release(Pointer sample);
    int cleave_sample_zero_copy(Pointer sample);
    int cleave_sample_cloud(Pointer sample, PointerByReference xyz, NativeLongByReference count);
    int cleave_sample_labels(Pointer sample, PointerByReference labels,
        NativeLongByReference count, Pointer timeNs);
    int cleave_sample_list(Pointer sample, List list);
  }

  @Structure.FieldOrder({"header", "cloudPublicationTimeNs", "cloudReceptionTimeNs", "outcome",
    "segments", "segmentCount", "borders", "borderCount", "queueMs", "segmentationMs"})
  public static class List extends Structure {
    public Pointer header;
    public long cloudPublicationTimeNs, cloudReceptionTimeNs;
    public int outcome;
    public Pointer segments;
    public NativeLong segmentCount;
    public Pointer borders;
    public NativeLong borderCount;
    public float queueMs, segmentationMs;
  }

  @Structure.FieldOrder({"label", "pointCount", "centroid", "meanNormal", "box", "rectangle",
    "planarity"})
  public static class Segment extends Structure {
    public short label;  // unsigned
    public int pointCount;
    public float[] centroid = new float[3], meanNormal = new float[3], box = new float[10];
    public int[] rectangle = new int[4];
    public float planarity;

    public Segment(Pointer place) {
      super(place);
      read();
    }
  }

  static class Failure extends RuntimeException {
    final int result;

    Failure(int result, String text) {
      super(text);
      this.result = result;
    }
  }

  static void check(int result) {
    if (result != C.OK) throw new Failure(result, C.cleave.cleave_error());  // this thread's
  }

  /** Of one sensor. For one thread at a time. */
  static class Frames implements AutoCloseable {
    private final PointerByReference handle = new PointerByReference();

    Frames(String sensor) {
      PointerByReference stream = new PointerByReference();
      check(C.cleave.cleave_open(null, stream));
      try {
        check(C.cleave.cleave_frames_open(stream.getValue(), sensor, handle));
      } finally {
        C.cleave.cleave_close(stream.getValue());  // it lives on for its frames
      }
    }

    Frame next(int timeoutMs) {
      PointerByReference cloud = new PointerByReference();
      PointerByReference labels = new PointerByReference();
      PointerByReference segments = new PointerByReference();
      check(C.cleave.cleave_frames_next(handle.getValue(), timeoutMs, cloud, labels, segments));
      return new Frame(cloud.getValue(), labels.getValue(), segments.getValue());
    }

    @Override
    public void close() {
      C.cleave.cleave_frames_close(handle.getValue());
    }
  }

  /**
   * A cloud, its label map and its segments. The buffers are views of the camera's grabber's own
   * memory, which goes back with close(): hold few frames, and use no buffer after its frame.
   */
  record Frame(Pointer cloud, Pointer labels, Pointer segments) implements AutoCloseable {
    FloatBuffer points() {
      PointerByReference xyz = new PointerByReference();
      NativeLongByReference count = new NativeLongByReference();
      check(C.cleave.cleave_sample_cloud(cloud, xyz, count));
      return xyz.getValue().getByteBuffer(0, 12 * count.getValue().longValue()).asFloatBuffer();
    }

    ShortBuffer labelMap() {
      PointerByReference place = new PointerByReference();
      NativeLongByReference count = new NativeLongByReference();
      check(C.cleave.cleave_sample_labels(labels, place, count, null));
      return place.getValue().getByteBuffer(0, 2 * count.getValue().longValue()).asShortBuffer();
    }

    List list() {
      List list = new List();
      check(C.cleave.cleave_sample_list(segments, list));
      return list;
    }

    @Override
    public void close() {
      C.cleave.cleave_release(cloud);
      C.cleave.cleave_release(labels);
      C.cleave.cleave_release(segments);
    }
  }

  static void print(Frame frame) {
    List list = frame.list();
    if (list.segmentCount.longValue() < 2) return;
    // Labels go by size: the first is most often the table, the second the largest object.
    Segment object = ((Segment[]) new Segment(list.segments).toArray(2))[1];
    long id = list.header.getLong(0);  // frame_id is the header's first
    float[] at = object.centroid;
    System.out.printf(Locale.ROOT,
        "frame %d: %d segments; the second has %d points around (%.2f, %.2f, %.2f) m%n",
        id, list.segmentCount.longValue(), object.pointCount, at[0], at[1], at[2]);
    FloatBuffer xyz = frame.points();
    ShortBuffer labels = frame.labelMap();
    float nearest = Float.POSITIVE_INFINITY;
    for (int i = 0; i < labels.limit(); ++i) {
      if (labels.get(i) == object.label) nearest = Math.min(nearest, xyz.get(3 * i + 2));
    }
    System.err.printf(Locale.ROOT, "frame %d: nearest point at %.3f m (%s)%n", id, nearest,
        C.cleave.cleave_sample_zero_copy(frame.cloud) != 0 ? "zero copy" : "copied");
  }

  static void run(String sensor, long left) {
    int abi = C.cleave.cleave_abi_version();
    if (abi != C.ABI_VERSION) {
      throw new Failure(C.FAILED,
          "libcleave-c has ABI version " + abi + ", this page is of " + C.ABI_VERSION);
    }
    try (Frames frames = new Frames(sensor)) {
      while (left > 0) {
        try (Frame frame = frames.next(5000)) {
          print(frame);
          --left;
        } catch (Failure failure) {
          if (failure.result == C.FAILED) throw failure;
          System.err.println(failure.getMessage());  // nobody there (any more): somebody may come
        }
      }
    }
  }

  public static void main(String[] arguments) {
    try {
      run(arguments.length > 0 ? arguments[0] : "camera",
          arguments.length > 1 ? Long.parseLong(arguments[1]) : Long.MAX_VALUE);
    } catch (Failure failure) {
      System.err.println(failure.getMessage());
      System.exit(1);
    } catch (NumberFormatException error) {
      System.err.println("FRAMES is a number, not '" + arguments[1] + "'");
      System.exit(1);
    }
  }
}
