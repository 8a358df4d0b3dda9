// SPDX-License-Identifier: BSD-3-Clause
// In C#, on Mono: prints the largest object of every frame, as 01_print_segments.cpp does, and the
// point of it that is nearest to the camera, read where the camera's grabber wrote it.
//
//     apt-get install mono-mcs mono-runtime
//     mcs -unsafe -out:build/release/object_cs.exe client/examples/csharp/LargestObject.cs
//     LD_LIBRARY_PATH=build/release/lib mono build/release/object_cs.exe [SENSOR [FRAMES]]
using System;
using System.Runtime.InteropServices;
using Microsoft.Win32.SafeHandles;

// Of cleave.h what is needed here.
static unsafe class C {
  public const int AbiVersion = 1, Ok = 0, Failed = 5;

  public struct Point { public float X, Y, Z; }

  public struct Box {
    public Point Centre;
    public fixed float Orientation[4];
    public Point Extent;
  }

  public struct Segment {
    public ushort Label;
    public uint PointCount;
    public Point Centroid, MeanNormal;
    public Box Box;
    public fixed uint Rectangle[4];
    public float Planarity;
  }

  public struct List {
    public ulong* Header;  // its first field is frame_id
    public long CloudPublicationTimeNs, CloudReceptionTimeNs;
    public uint Outcome;
    public Segment* Segments;
    public UIntPtr SegmentCount;
    public IntPtr Borders;
    public UIntPtr BorderCount;
    public float QueueMs, SegmentationMs;
  }

  const string library = "cleave-c";
  [DllImport(library)] public static extern uint cleave_abi_version();
  [DllImport(library)] public static extern IntPtr cleave_error();
  [DllImport(library)] public static extern int cleave_open(IntPtr options, out Stream stream);
  [DllImport(library)] public static extern void cleave_close(IntPtr stream);
  [DllImport(library)] public static extern int cleave_frames_open(
    Stream stream, string sensor, out Frames frames);
  [DllImport(library)] public static extern void cleave_frames_close(IntPtr frames);
  [DllImport(library)] public static extern int cleave_frames_next(
    Frames frames, int timeoutMs, out Sample cloud, out Sample labels, out Sample segments);
  [DllImport(library)] public static extern void cleave_release(IntPtr sample);
  [DllImport(library)] public static extern int cleave_sample_zero_copy(Sample sample);
  [DllImport(library)] public static extern int cleave_sample_cloud(
    Sample sample, out Point* points, out UIntPtr count);
  [DllImport(library)] public static extern int cleave_sample_labels(
    Sample sample, out ushort* labels, out UIntPtr count, IntPtr timeNs);
  [DllImport(library)] public static extern int cleave_sample_list(Sample sample, out List list);

  public static string Error() => Marshal.PtrToStringAnsi(cleave_error());

  public static void Check(int result) {
    if (result != Ok) throw new Failure(Error());
  }
}

class Failure : Exception {
  public Failure(string text) : base(text) {}
}

// Handles may be closed in any order and on any thread, so the runtime's finaliser may do it, too.
class Stream : SafeHandleZeroOrMinusOneIsInvalid {
  Stream() : base(true) {}
  protected override bool ReleaseHandle() { C.cleave_close(handle); return true; }
}

// Of one sensor. For one thread at a time.
class Frames : SafeHandleZeroOrMinusOneIsInvalid {
  Frames() : base(true) {}
  protected override bool ReleaseHandle() { C.cleave_frames_close(handle); return true; }
}

// What it points to is the memory of the camera's grabber until it is disposed of: hold few.
class Sample : SafeHandleZeroOrMinusOneIsInvalid {
  Sample() : base(true) {}
  protected override bool ReleaseHandle() { C.cleave_release(handle); return true; }
}

static unsafe class LargestObject {
  static float Nearest(Sample cloud, Sample labels, ushort label) {
    C.Check(C.cleave_sample_cloud(cloud, out C.Point* points, out UIntPtr count));
    C.Check(C.cleave_sample_labels(labels, out ushort* labelOf, out count, IntPtr.Zero));
    float nearest = float.PositiveInfinity;
    for (ulong i = 0; i < (ulong)count; ++i) {
      if (labelOf[i] == label) nearest = Math.Min(nearest, points[i].Z);
    }
    return nearest;
  }

  static void Print(Sample cloud, Sample labels, Sample segments) {
    C.Check(C.cleave_sample_list(segments, out C.List list));
    if ((ulong)list.SegmentCount < 2) return;
    // Labels go by size: the first is most often the table, the second the largest object.
    C.Segment* second = &list.Segments[1];
    C.Point at = second->Centroid;
    Console.WriteLine(FormattableString.Invariant(
      $"frame {*list.Header}: {list.SegmentCount} segments; the second has {second->PointCount} ") +
      FormattableString.Invariant($"points around ({at.X:F2}, {at.Y:F2}, {at.Z:F2}) m"));
    float nearest = Nearest(cloud, labels, second->Label);
    string how = C.cleave_sample_zero_copy(cloud) != 0 ? "zero copy" : "copied";
    Console.Error.WriteLine(FormattableString.Invariant(
      $"frame {*list.Header}: nearest point at {nearest:F3} m ({how})"));
  }

  static void Run(string sensor, ulong left) {
    if (C.cleave_abi_version() != C.AbiVersion) {
      throw new Failure(
        $"libcleave-c has ABI version {C.cleave_abi_version()}, this page is of {C.AbiVersion}");
    }
    C.Check(C.cleave_open(IntPtr.Zero, out Stream stream));
    using (stream) {
      C.Check(C.cleave_frames_open(stream, sensor, out Frames frames));
      using (frames) {
        while (left > 0) {
          int result = C.cleave_frames_next(
            frames, 5000, out Sample cloud, out Sample labels, out Sample segments);
          if (result == C.Failed) C.Check(result);
          if (result != C.Ok) {
            Console.Error.WriteLine(C.Error());  // nobody there (any more): somebody may come
            continue;
          }
          using (cloud) using (labels) using (segments) Print(cloud, labels, segments);
          --left;
        }
      }
    }
  }

  static int Main(string[] arguments) {
    try {
      ulong left = ulong.MaxValue;
      if (arguments.Length > 1 && !ulong.TryParse(arguments[1], out left)) {
        throw new Failure($"FRAMES is a number, not '{arguments[1]}'");
      }
      Run(arguments.Length > 0 ? arguments[0] : "camera", left);
      return 0;
    } catch (Failure failure) {
      Console.Error.WriteLine(failure.Message);
      return 1;
    }
  }
}
