// SPDX-License-Identifier: BSD-3-Clause
// A page: views of the model and, over them, lines, boxes and text at places given in pixels.
//
// Places on the page are in pixels of the finished picture, x to the right, y DOWN from the top left corner.
// The page is drawn two or three times as large in both directions and reduced (image.h); drawn_pixels says how many
// drawn pixels one is.
#pragma once

#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "colour.h"
#include "image.h"
#include "mesh.h"
#include "offscreen_window.h"

namespace hfrac::viz {

// The letters of pictures and charts: DejaVu where it is installed, VTK's own otherwise.

// The font's file; empty where there is none.
std::string font_file(bool bold);

// Makes a text property bold or not, `size` drawn pixels high, in a colour.
void set_font(vtkTextProperty* property, bool bold, double size, Colour colour);

// A page drawn band by band, each several times too large and reduced. The window's buffers take over 30 bytes per drawn
// pixel; for a whole page at once the system takes longer to hand out that memory than the picture to draw.

// Rows of the page, counted up from its lower edge; the outermost bands reach beyond the page.
struct PageBand {
  int bottom = 0;  // [pixel]
  int rows = 0;    // [pixel]
};

// `show` arranges what is in the window so that it shows that band, `factor` drawn pixels to a pixel of the page, and
// renders it.
Image drawn_in_bands(OffscreenWindow* window, int width, int height, int factor,
                     const std::function<void(const PageBand&)>& show);

struct Box {
  double left = 0;
  double top = 0;
  double width = 0;
  double height = 0;
  double right() const { return left + width; }
  double bottom() const { return top + height; }
};

// A part of the model, in metres, y up.
struct Extent {
  double left = 0;
  double bottom = 0;
  double width = 0;
  double height = 0;
};

inline Bounds bounds_of(const Extent& extent) {
  return {extent.left, extent.left + extent.width, extent.bottom, extent.bottom + extent.height};
}

enum class Align { left, centre, right };

struct TextStyle {
  double size = 20;  // [pixel] of the em
  Colour colour = palette().ink;
  bool bold = false;
  Align align = Align::left;
  bool upwards = false;  // turned by 90 degrees
};

// A view of the model on a page: add actors in metres to the renderer.
struct View {
  Box box;
  Extent extent;
  double metres_per_pixel = 0;  // finished pixels
  vtkSmartPointer<vtkRenderer> renderer;

  double to_page_x(double x) const { return box.left + (x - extent.left) / metres_per_pixel; }
  double to_page_y(double y) const { return box.bottom() - (y - extent.bottom) / metres_per_pixel; }
};

// A text on a page; x, y: the start (middle, end) of its baseline.
struct PageText {
  double x = 0;
  double y = 0;
  std::string content;
  TextStyle style;
};

class Page {
 public:
  // `factor`: how many times larger it is drawn.
  Page(OffscreenWindow* window, int width, int height, int factor = 2);
  ~Page();
  Page(const Page&) = delete;
  Page& operator=(const Page&) = delete;

  int width() const { return width_; }
  int height() const { return height_; }
  int drawn_pixels() const { return factor_; }

  // A view of `extent`, as large as fits into `room`, at its top left corner.
  View view(const Box& room, const Extent& extent);
  void line(double x0, double y0, double x1, double y1, double width, Colour colour);
  void rectangle(const Box& box, Colour colour);
  void outline(const Box& box, double width, Colour colour);
  void circle(double x, double y, double radius, Colour colour);
  void polygon(const std::vector<Point>& corners, Colour colour);
  // x, y: the start (middle, end) of the text's baseline.
  void text(double x, double y, const std::string& content, const TextStyle& style);
  // Width of a text in pixels.
  double text_width(const std::string& content, const TextStyle& style) const;

  Image draw();
  // The same as vectors, see vector_page.h.
  std::string svg(const std::string& title) const;
  std::vector<std::uint8_t> pdf(const std::string& title, int dots_per_inch) const;

 private:
  // A text as VTK draws it; `at` in drawn pixels of the page.
  struct Letters {
    vtkSmartPointer<vtkTextActor> actor;
    Point at;
  };

  void show_part(const View& view, const PageBand& band) const;
  vtkSmartPointer<vtkActor> overlay_shapes() const;
  vtkSmartPointer<vtkTextProperty> text_property(const TextStyle& style) const;
  Point place(double x, double y) const { return {x * factor_, (height_ - y) * factor_}; }

  OffscreenWindow* window_;
  int width_;
  int height_;
  int factor_;
  Mesh shapes_;
  std::vector<vtkSmartPointer<vtkRenderer>> renderers_;
  std::vector<View> views_;
  std::vector<PageText> texts_;
  std::vector<Letters> letters_;
  vtkSmartPointer<vtkRenderer> overlay_;
};

// A finished page as the content of a file: pixels, or circles, lines and letters; the ending of its name says which.

// ".png", ".svg" or ".pdf". Throws Failure(HFRAC_ERR_ARGUMENT) for any other ending.
std::string picture_ending(const std::filesystem::path& target);

// `title`: of the document. dots_per_inch: how large a PNG or PDF is on paper, 0: not said (PDF: 96).
std::vector<std::uint8_t> page_content(Page& page, const std::string& ending, const std::string& title,
                                       int dots_per_inch);

}  // namespace hfrac::viz
