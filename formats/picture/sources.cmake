# SPDX-License-Identifier: MIT
# What picture is compiled from, once for every build of it: this folder's and the WebAssembly modules'.
set(sinew_picture_sources
  draw/animated_png
  draw/draw_in_plane
  draw/sprite_sheet
  mesh/contour
  mesh/delaunay
  mesh/inflation
  mesh/picture_mesh
  mesh/plane_mesh
  outline/background
  outline/choose_part
  outline/find_figure
  outline/foreground
  outline/holes
  outline/inner_lines
  outline/lab
  outline/outline
  outline/raster
  outline/sheet
  read/exif
  read/read_jpeg
  read/read_picture
  read/read_png
  read/read_stb)
list(TRANSFORM sinew_picture_sources PREPEND ${CMAKE_CURRENT_LIST_DIR}/src/)
list(TRANSFORM sinew_picture_sources APPEND .cpp)
