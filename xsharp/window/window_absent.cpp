// The window of a build without SDL2.
#include <stdexcept>

#include "xsharp/window/window.hpp"

namespace xsharp {

class Window::Implementation {};

bool window_available() { return false; }

Window::Window(const std::string& /*title*/, std::int32_t /*width*/, std::int32_t /*height*/) {
  throw std::runtime_error("cannot open a window: this was built without SDL2");
}
Window::~Window() = default;

// Never reached: the constructor throws.
void Window::set_title(const std::string& /*title*/) {}
void Window::show(const Page<std::uint32_t>& /*page*/) {}
void Window::show(const Page<std::uint8_t>& /*page*/, const Palette& /*palette*/) {}
std::vector<Key> Window::keys() { return {}; }

}  // namespace xsharp
