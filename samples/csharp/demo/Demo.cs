// SPDX-License-Identifier: MIT
// What a program does with a character: opens a file, binds it, saves it.
//   mono Demo.exe IN OUT [MOTION]
using System;
using Sinew;

static class Demo
{
    static int Main(string[] args)
    {
        if (args.Length < 2)
        {
            Console.Error.WriteLine("usage: Demo.exe IN OUT [MOTION]");
            return 2;
        }
        try
        {
            using (Character one = Character.Open(args[0]))
            {
                if (one.Skeleton == null) Console.WriteLine("skeleton: off by {0:P1} of the size", one.Rig().Spread);
                else Console.WriteLine("weights: {0}", one.Bind().Hash);
                if (args.Length > 2)
                    using (Character motion = Character.Open(args[2])) Console.WriteLine("clips: {0}", one.Animate(motion).ClipCount);
                one.Save(args[1]);
                Console.Write(one.Notes);
            }
            return 0;
        }
        catch (SinewException e)
        {
            Console.Error.WriteLine(e.Message);
            return 1;
        }
    }
}
