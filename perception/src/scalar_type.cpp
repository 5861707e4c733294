#include "scenelore/perception/point_table.hpp"

namespace scenelore::perception {

std::size_t size_of(ScalarType type) {
  switch (type) {
    case ScalarType::i8:
    case ScalarType::u8: return 1;
    case ScalarType::i16:
    case ScalarType::u16: return 2;
    case ScalarType::i32:
    case ScalarType::u32:
    case ScalarType::f32: return 4;
    case ScalarType::i64:
    case ScalarType::u64:
    case ScalarType::f64: return 8;
  }
  return 0;
}

}  // namespace scenelore::perception
