#include "geometry_blob.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

#include "scenelore/kb/error.hpp"

namespace scenelore::kb {

static_assert(std::endian::native == std::endian::little, "blobs are written as they lie in memory");

namespace {

constexpr std::uint32_t kPolygon = 3, kPolygonZ = 1003;  // ISO WKB types
constexpr std::int32_t kUndefinedCartesian = -1;         // srs_id
constexpr std::uint8_t kLittleEndian = 1, kEmpty = 0x10;
constexpr std::array<std::size_t, 5> kEnvelopeBytes = {0, 32, 48, 48, 64};  // by envelope code

template <typename T>
void put(std::vector<std::byte>& blob, T value) {
  const auto bytes = std::bit_cast<std::array<std::byte, sizeof(T)>>(value);
  blob.insert(blob.end(), bytes.begin(), bytes.end());
}

void put_ring(std::vector<std::byte>& blob, const perception::Ring& ring, int dimensions) {
  put(blob, static_cast<std::uint32_t>(ring.size() + 1));
  for (std::size_t i = 0; i <= ring.size(); ++i) {
    for (int axis = 0; axis < dimensions; ++axis) put(blob, ring[i % ring.size()][axis]);
  }
}

// Reads forward through a blob and refuses to run over its end.
class Reader {
 public:
  explicit Reader(std::span<const std::byte> blob) : rest_(blob) {}
  template <typename T>
  T get() {
    T value;
    std::memcpy(&value, take(sizeof(T)).data(), sizeof(T));
    return value;
  }
  std::span<const std::byte> take(std::size_t size) {
    if (size > rest_.size()) throw Error("geometry blob ends too early");
    const auto taken = rest_.first(size);
    rest_ = rest_.subspan(size);
    return taken;
  }
  [[nodiscard]] std::size_t left() const { return rest_.size(); }

 private:
  std::span<const std::byte> rest_;
};

perception::Ring get_ring(Reader& reader) {
  const auto corners = reader.get<std::uint32_t>();
  if (corners > reader.left() / 24) throw Error("geometry blob ends too early");
  perception::Ring ring(corners);
  for (Eigen::Vector3d& corner : ring) {
    for (int axis = 0; axis < 3; ++axis) corner[axis] = reader.get<double>();
  }
  if (!ring.empty()) ring.pop_back();  // the first corner again
  return ring;
}

}  // namespace

std::vector<std::byte> encode_polygon(const perception::Polygon& polygon, Dimensions dimensions) {
  const int axes = dimensions == Dimensions::xyz ? 3 : 2;
  const bool empty = polygon.outer.empty();
  std::vector<std::byte> blob;
  put(blob, 'G');
  put(blob, 'P');
  put(blob, std::uint8_t{0});  // version
  const int envelope = axes == 3 ? 2 : 1;
  put(blob, static_cast<std::uint8_t>(empty ? kEmpty | kLittleEndian : envelope << 1 | kLittleEndian));
  put(blob, kUndefinedCartesian);
  if (!empty) {
    Eigen::Vector3d low = polygon.outer.front(), high = low;
    for (const Eigen::Vector3d& corner : polygon.outer) {
      low = low.cwiseMin(corner);
      high = high.cwiseMax(corner);
    }
    for (int axis = 0; axis < axes; ++axis) {
      put(blob, low[axis]);
      put(blob, high[axis]);
    }
  }
  put(blob, kLittleEndian);
  put(blob, axes == 3 ? kPolygonZ : kPolygon);
  put(blob, static_cast<std::uint32_t>(empty ? 0 : 1 + polygon.holes.size()));
  if (empty) return blob;
  put_ring(blob, polygon.outer, axes);
  for (const perception::Ring& hole : polygon.holes) put_ring(blob, hole, axes);
  return blob;
}

perception::Polygon decode_polygon(std::span<const std::byte> blob) {
  Reader reader(blob);
  if (reader.get<char>() != 'G' || reader.get<char>() != 'P') throw Error("not a GeoPackage geometry blob");
  reader.take(1);  // version
  const auto flags = reader.get<std::uint8_t>();
  const unsigned envelope = flags >> 1 & 7u;
  if ((flags & 1) == 0 || envelope >= kEnvelopeBytes.size()) throw Error("geometry blob of an unknown kind");
  reader.take(4 + kEnvelopeBytes[envelope]);
  if (reader.get<std::uint8_t>() != kLittleEndian) throw Error("geometry blob of an unknown kind");
  const auto type = reader.get<std::uint32_t>();
  // GDAL may write the older 2.5D code of the same thing.
  if (type != kPolygonZ && type != 0x80000003u) throw Error("geometry blob is no POLYGON Z");
  const auto rings = reader.get<std::uint32_t>();
  perception::Polygon polygon;
  if (rings > 0) polygon.outer = get_ring(reader);
  for (std::uint32_t i = 1; i < rings; ++i) polygon.holes.push_back(get_ring(reader));
  return polygon;
}

}  // namespace scenelore::kb
