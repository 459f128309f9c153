#include "core/pattern/pavement_walls.h"

#include <cstddef>

namespace lentray::core {
namespace {

constexpr PavementWalls kOneTriangle[] = {{0, "7"}};
constexpr PavementWalls kTwoTriangles[] = {{0, "5"}};
constexpr PavementWalls kThreeTriangles[] = {{1, "351"}};
constexpr PavementWalls kFourTriangles[] = {
    {1, "51"},
    {1, "25"},
    {0, "35 60"},
};
constexpr PavementWalls kFiveTriangles[] = {
    {2, "31511"},
    {2, "31216"},
    {2, "51254"},
    {3, "31630"},
};
constexpr PavementWalls kSixTriangles[] = {
    {0, "311"},     {0, "611"},     {1, "611"},      {1, "315 160"},
    {1, "313 230"}, {2, "331 212"}, {1, "31 54 12"}, {1, "31 45 03"},
    {1, "351 250"}, {0, "341"},     {1, "350"},      {1, "241"},
};
constexpr PavementWalls kOneSquare[] = {{0, "3"}};
constexpr PavementWalls kTwoSquares[] = {{0, "3 2"}};
constexpr PavementWalls kThreeSquares[] = {
    {0, "311"},
    {0, "331 212"},
};
constexpr PavementWalls kFourSquares[] = {
    {0, "3111"}, {0, "3311 2112"}, {2, "3112"}, {0, "31 20"}, {1, "13 30"},
};
constexpr PavementWalls kFiveSquares[] = {
    {0, "31111"}, {0, "33111 21112"}, {2, "13131 30020"}, {3, "31112"},
    {3, "30123"}, {9, "3221131122"},  {9, "2321213121"},  {7, "3112323210"},
    {4, "32112"}, {2, "33012 21123"}, {1, "13113 30310"}, {2, "3113012232"},
};
constexpr PavementWalls kSixSquares[] = {
    {0, "311111"},          {0, "311113 231110"},   {0, "311113 123110"},  {0, "311113 112310"},
    {1, "303111"},          {0, "311131 203100"},   {0, "131311 300120"},  {1, "310311"},
    {0, "131 300"},         {0, "311 200"},         {0, "3311 2120 2012"}, {5, "311212"},
    {0, "3111 3232 2101"},  {0, "311 123 221 013"}, {1, "310 320"},        {4, "330120"},
    {5, "301132 323101"},   {5, "323110 211132"},   {5, "321122"},         {1, "231103"},
    {1, "223111"},          {0, "3111 2332 1021"},  {0, "2301 2112 3232"}, {2, "313102 321121"},
    {0, "31 12 21"},        {0, "31 20 12"},        {0, "31 03 21"},       {5, "321121"},
    {2, "312321 121031"},   {3, "132112 301231"},   {3, "310132 231103"},  {2, "323101"},
    {0, "311 312 230 211"}, {5, "301132323110"},    {2, "2310 2112 2332"},
};
constexpr PavementWalls kOneHexagon[] = {{1, "241"}};
constexpr PavementWalls kTwoHexagons[] = {{2, "241 104"}};
constexpr PavementWalls kThreeHexagons[] = {
    {0, "241 124 402 240 024 402"},
    {5, "241200201 104124004"},
    {4, "241241001"},
};
constexpr PavementWalls kFourHexagons[] = {
    {2, "241 124 402 240 024 402 240 024"},
    {2, "200041 124100"},
    {5, "201001 124124"},
    {1, "240240241041"},
    {2, "241040201240 124104124120"},
    {2, "240241201200 104024004124"},
    {2, "241241 104020"},
};
constexpr PavementWalls kFiveHexagons[] = {
    {1, "241 124 402 240 024 402 240 024 402 240"},
    {1, "041240240240241"},
    {1, "241 104 002 241 024 402 240 024 012 040"},
    {1, "240 104 002 241 024 402 201 004 412 240"},
    {1, "040241240240241"},
    {1, "241 104 002 040 124 402 240 104 002 040"},
    {1, "200 124 012 040 020 400 241 104 002 040"},
    {4, "041241241040040201240200241041"},
    {11, "001201240240241 120124024104124"},
    {2, "241241240241241 104100104024100"},
    {11, "241200241241200 104000120104004"},
    {10, "241201040000241"},
    {8, "201241240201241 124020104124100"},
    {13, "241240201201240"},
    {13, "241240240201201"},
    {11, "201041240240001 120024020124124"},
    {5, "041040241241240 100020104124024"},
    {11, "241241240240241 100124024020104"},
    {8, "241241240240241 024024100120104"},
    {1, "241 104 002 201 124 402 240 120 012 040"},
    {13, "241240201240201"},
    {11, "241241241240240 120104024024100"},
};

constexpr std::span<const PavementWalls> kTriangles[] = {
    kOneTriangle, kTwoTriangles, kThreeTriangles, kFourTriangles, kFiveTriangles, kSixTriangles};

constexpr std::span<const PavementWalls> kSquares[] = {kOneSquare,   kTwoSquares,  kThreeSquares,
                                                       kFourSquares, kFiveSquares, kSixSquares};

constexpr std::span<const PavementWalls> kHexagons[] = {kOneHexagon, kTwoHexagons, kThreeHexagons,
                                                        kFourHexagons, kFiveHexagons};

}  // namespace

std::span<const PavementWalls> pavement_walls(int sides, int tiles) {
  std::span<const std::span<const PavementWalls>> all;
  if (sides == 3) all = kTriangles;
  if (sides == 4) all = kSquares;
  if (sides == 6) all = kHexagons;
  if (tiles < 1 || tiles > static_cast<int>(all.size())) return {};
  return all[static_cast<std::size_t>(tiles - 1)];
}

}  // namespace lentray::core
