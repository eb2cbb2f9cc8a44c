// Blocks without a copy: any reader of buffers, NumPy above all, sees the numbers where they are.
#include <utility>
#include <vector>

#include "arguments.hpp"
#include "bind.hpp"

namespace changeover::python {
namespace {

py::tuple row(const Blocks& blocks, std::size_t index) {
  py::tuple elements(blocks.k);
  for (std::size_t i = 0; i < blocks.k; ++i) {
    elements[i] = py::int_(blocks.data[index * blocks.k + i]);
  }
  return elements;
}

std::size_t place(const Blocks& blocks, const py::handle& index) {
  if (PyIndex_Check(index.ptr()) == 0) {
    throw py::type_error("blocks have a number or a slice as index, not " +
                         quoted(words_of(py::repr(index))));
  }
  const auto count = static_cast<py::ssize_t>(blocks.count);
  // A number that is too large for any index is one that is not there.
  const py::ssize_t at = PyNumber_AsSsize_t(index.ptr(), nullptr);
  if (at == -1 && PyErr_Occurred() != nullptr) {
    throw py::error_already_set();
  }
  if (at < -count || at >= count) {
    throw py::index_error("there are " + std::to_string(count) + " blocks");
  }
  return static_cast<std::size_t>(at < 0 ? at + count : at);
}

Blocks part(const Blocks& blocks, const py::slice& slice) {
  py::ssize_t from = 0;
  py::ssize_t to = 0;
  py::ssize_t step = 0;
  py::ssize_t length = 0;
  if (!slice.compute(static_cast<py::ssize_t>(blocks.count), &from, &to, &step, &length)) {
    throw py::error_already_set();
  }
  if (step == 1) {
    return {blocks.owner, blocks.data + static_cast<std::size_t>(from) * blocks.k,
            static_cast<std::size_t>(length), blocks.k};
  }
  const auto copy = std::make_shared<std::vector<Element>>();
  for (py::ssize_t i = 0; i < length; ++i) {
    const Element* const start = blocks.data + static_cast<std::size_t>(from + i * step) * blocks.k;
    copy->insert(copy->end(), start, start + blocks.k);
  }
  return {copy, copy->data(), static_cast<std::size_t>(length), blocks.k};
}

// One block after another.
struct BlockIterator {
  Blocks blocks;
  std::size_t next = 0;
};

bool equal(const Blocks& a, const Blocks& b) {
  return a.k == b.k && a.count == b.count && std::equal(a.data, a.data + a.count * a.k, b.data);
}

}  // namespace

Blocks blocks_of(const std::shared_ptr<const Design>& design) {
  return {design, design->elements().data(), design->block_count(),
          static_cast<std::size_t>(design->k())};
}

void bind_blocks(py::module_& module) {
  py::class_<BlockIterator>(module, "_BlockIterator")
      .def("__iter__", [](py::object self) { return self; })
      .def("__next__", [](BlockIterator& self) {
        if (self.next == self.blocks.count) {
          throw py::stop_iteration();
        }
        return row(self.blocks, self.next++);
      });
  py::class_<Blocks>(
      module, "Blocks", py::buffer_protocol(),
      "Blocks in order: a read-only sequence of tuples of element numbers, and a buffer of shape (b, k) of "
      "unsigned 32-bit integers that NumPy wraps without a copy: numpy.asarray(blocks).")
      .def_buffer([](Blocks& self) {
        constexpr auto size = static_cast<py::ssize_t>(sizeof(Element));
        return py::buffer_info(
            const_cast<Element*>(
                self.data),  // NOLINT(cppcoreguidelines-pro-type-const-cast): read-only
            size, py::format_descriptor<Element>::format(), 2,
            {static_cast<py::ssize_t>(self.count), static_cast<py::ssize_t>(self.k)},
            {static_cast<py::ssize_t>(self.k) * size, size}, true);
      })
      .def("__len__", [](const Blocks& self) { return self.count; })
      .def("__getitem__",
           [](const Blocks& self, const py::object& index) -> py::object {
             return py::isinstance<py::slice>(index) ? py::cast(part(self, index.cast<py::slice>()))
                                                     : py::object(row(self, place(self, index)));
           })
      .def("__iter__", [](const Blocks& self) { return BlockIterator{self}; })
      .def("__eq__", &equal, py::is_operator())
      .def_property_readonly(
          "shape", [](const Blocks& self) { return py::make_tuple(self.count, self.k); }, "(b, k)")
      .def(
          "tolist",
          [](const Blocks& self) {
            py::list rows(self.count);
            for (std::size_t i = 0; i < self.count; ++i) {
              rows[i] = py::list(row(self, i));
            }
            return rows;
          },
          "A list of lists of int.")
      .def("__repr__", [](const Blocks& self) {
        return "<" + std::to_string(self.count) + " blocks of " + std::to_string(self.k) +
               " elements>";
      });
}

}  // namespace changeover::python
