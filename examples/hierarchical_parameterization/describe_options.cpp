// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The texts of --help.

#include "describe_options.h"

#include "methods.h"

#include <boost/program_options.hpp>

#include <iostream>
#include <string>

namespace {

po::options_description general_options(Options& options)
{
  po::options_description described("General");
  auto add = described.add_options();
  add("help,h", "print this text");
  add("version", "print the version");
  add("quiet", po::bool_switch(&options.quiet), "print errors only");
  return described;
}

po::options_description input_options(Options& options)
{
  po::options_description described("Input");
  auto add = described.add_options();
  add("triangulate", po::bool_switch(&options.is_triangulated), "cut faces of more than three corners into triangles");
  add("orient", po::bool_switch(&options.is_oriented),
      "turn faces so that neighbors, which share points, have one orientation. Where that cannot be, where more than "
      "two faces meet at an edge or several fans at a vertex, the surface is cut: points are there several times then, "
      "the new ones behind those of the input. Corners that repeat the one before are left out, and so are faces of "
      "less than three vertices");
  add("stitch", po::bool_switch(&options.is_stitched),
      "join borders whose points coincide, as where every face has points of its own. Of points that are joined, the "
      "first one stays; the numbers of those behind it change, also for --hold and --start, which count those of the "
      "output. With --orient, too, all points that coincide are joined before faces are turned");
  return described;
}

po::options_description method_options(Options& options, Words& words, Numbers& numbers)
{
  po::options_description described("Method");
  auto add = described.add_options();
  add("method", po::value(&words.method)->default_value("mips"), "one of those above");
  add("tolerance", po::value(&options.tolerance),
      "mips, symmetric-dirichlet, arap: converged when a step lowers the energy by less than this part of its excess "
      "over the lower bound (default 1e-6); others: when the relative residual is not greater (default 1e-8, of CGAL's "
      "1e-10)");
  add("iterations", po::value(&numbers.iterations),
      "mips, symmetric-dirichlet, arap: the most steps of Newton's method on a level (default 200; 0: vertices are "
      "only relaxed one by one); others: of the linear solver, before a direct one takes over (default 300; 0: at "
      "once)");
  add("weights", po::value(&words.weights),
      "mips, symmetric-dirichlet: of the triangles: triangle (all alike; default of mips) or area (in space; default "
      "of symmetric-dirichlet)");
  add("flips", po::value(&words.flips)->default_value("repair"),
      "not for mips and symmetric-dirichlet, which flip no triangle: repair (default), fail (an error) or keep");
  add("globally-injective", po::bool_switch(&options.is_globally_injective),
      "mips, symmetric-dirichlet: keep the free border from running over itself, whatever that costs. By default a "
      "chart for which it costs much becomes an atlas instead; with --cut none, --flat, --levels, --start and --hold "
      "borders are kept apart by this option only");
  add("fill-holes", po::bool_switch(&options.fills_holes),
      "close every border but the longest one by a virtual vertex, so that a hole is laid out as a part of the "
      "surface");
  add("start", po::value(&options.start),
      "mips, symmetric-dirichlet, arap: start from the map that this file has for the vertices of INPUT: PLY with u "
      "and v, or OBJ, as --output writes them for one chart");
  add("hold", po::value(&options.hold),
      "mips, symmetric-dirichlet, arap: hold vertices at the places that this file has: lines of a vertex, counted "
      "from 0, and its two coordinates; lines that are empty or begin with # are none");
  add("flat", po::bool_switch(&options.flat),
      "run the method without the hierarchy; those of CGAL as they are shipped. --tolerance and --iterations are for "
      "mips and symmetric-dirichlet then: a direct solver, or CGAL, takes neither");
  add("seed", po::value(&numbers.seed)->default_value(0),
      "of the random choices of the hierarchy: the same seed gives the same result");
  add("threads", po::value(&options.threads)->default_value(0),
      "the most threads to use, if built with TBB; 0: as many as there are. The result is the same");
  return described;
}

po::options_description atlas_options(Options& options, Words& words)
{
  po::options_description described("Charts and atlases");
  auto add = described.add_options();
  add("components", po::value(&words.components),
      "all (default): lay out every component, and pack the charts into the unit square; or largest: the one with the "
      "most faces. The default is largest with --flat, --levels, --start and --hold, which take one chart");
  add("cut", po::value(&words.cut),
      "auto (default): cut components that are closed or have handles along short seams; or none: leave them out, and "
      "let one chart overlap itself. The default is none with --flat, --levels, --start and --hold. With none there "
      "are no --distortion-bound, --overlap-bound, --sharp-angle and --least-used-part");
  add("atlas", po::bool_switch(&options.makes_atlas),
      "make an atlas of one component, too: its chart or charts in the unit square");
  add("least-used-part", po::value<double>(),
      "divide charts by short cuts until they cover this part of the unit square, from 0 to 1, or no cut helps; 0.7 is "
      "within reach of most surfaces; 0: none. The default is 0.25. Makes an atlas of one component, too");
  add("distortion-bound", po::value<double>(),
      "cut surfaces until symmetric Dirichlet maps of them have a mean energy, 4 without distortion, within this "
      "bound, as far as 50 branches of the seam lead; maps of other methods may exceed it. inf: only what must be cut. "
      "The default is 4.5 for surfaces that must be cut or exceed 8. Makes an atlas of one component, too");
  add("overlap-bound", po::value<double>(),
      "divide charts in which more than this fraction of the triangles, from 0 to 1, would overlap others; 1: none. "
      "The default is 0.2. Makes an atlas of one component, too");
  add("hole-bound", po::value<double>(),
      "in an atlas, treat holes as parts of the surface whose border is no longer than this part, from 0 to 1, of the "
      "square root of their component's area; 0: none. The default is 0.1. Makes an atlas of one component, too");
  add("sharp-angle", po::value<double>(),
      "part the surface into regions along edges at which it turns by at least this angle, from 0 to 180 degrees: 40, "
      "for instance, parts the faces of a mechanical model, most of which have maps without distortion. Each region "
      "has the distortion bound 4.5 unless another one is given. Makes an atlas of one component, too");
  add("margin", po::value<double>(),
      "keep at least this part of the square's side, from 0 to 0.1, between charts, and half of it around them. The "
      "default is 1/256, less for many charts. Makes an atlas of one component, too");
  return described;
}

po::options_description output_options(Options& options)
{
  po::options_description described("Output");
  auto add = described.add_options();
  add("output", po::value(&options.output),
      "write the mesh with its map as OBJ, PLY or binary glTF (.glb); as OBJ if the name has no ending. PLY has the "
      "vertex properties u and v, or the list texcoord of each face if corners of a vertex may have several places");
  add("binary", po::bool_switch(&options.is_output_binary),
      "write PLY in binary: two fifths shorter, in a third of the time. Then texcoord is a list of doubles");
  add("picture", po::value(&options.picture), "draw the map as SVG, colored by distortion");
  add("report", po::value(&options.report), "write figures as JSON, one line per input");
  add("levels", po::value(&options.levels),
      "write every level of the hierarchy as OBJ into this folder: level_00.obj, the coarsest one, and so on, with "
      "maps before the repair of flips. Files of an earlier run that had more levels stay there");
  return described;
}

std::string list_of_methods()
{
  std::string list;
  for (const Method& m : methods())
    list += "\n  " + m.name + ": " + m.description + (m.is_flip_free ? "; no triangle flips" : "");
  return list;
}

} // namespace

po::options_description describe_options(Options& options, Words& words, Numbers& numbers)
{
  po::options_description described;
  described.add(general_options(options)).add(input_options(options)).add(method_options(options, words, numbers))
      .add(atlas_options(options, words)).add(output_options(options));
  return described;
}

void print_help(const po::options_description& described)
{
  std::cout << "Usage: hierarchical_parameterization [INPUT ...] [OPTION ...]\n\n"
               "Lays triangulated surfaces (OFF, OBJ, PLY or STL) in the plane, coarse to fine.\n"
               "One component that has a border and no handles becomes one chart. Anything else becomes an atlas: cut "
               "into charts, all at one scale, in the unit square. So does one chart that mips or symmetric-dirichlet "
               "would lay over itself, unless its borders can be kept apart with little distortion.\n"
               "Without INPUT: a built-in face of 1042 vertices. INPUT may be -, the standard input.\n"
               "The file of --output, --picture or --report may be -, the standard output; the summary goes to "
               "stderr then.\n"
               "In the names of --output and --picture, {.} stands for INPUT without its ending, and {/.} for the same "
               "without its folder.\n\n"
               "Examples:\n"
               "  hierarchical_parameterization scan.ply --output scan.obj --picture map.svg\n"
               "  hierarchical_parameterization --method symmetric-dirichlet statue.stl --output statue.glb\n"
               "  hierarchical_parameterization --method symmetric-dirichlet --globally-injective scan.ply --output "
               "map.ply\n"
               "  hierarchical_parameterization charts/*.off --output 'maps/{/.}.ply' --report maps/report.json\n"
               "  find charts -name '*.off' -print0 | xargs -0 -P 8 -n 100 hierarchical_parameterization --quiet "
               "--threads 1 --report -\n\n"
               "Methods:"
            << list_of_methods() << "\n"
            << described
            << "\n"
               "Exit status: 0 maps written, 1 wrong usage, 2 an input cannot be read or is no surface to "
               "parameterize, or a part of it was left out, 3 a method failed or a file cannot be written.\n";
}
