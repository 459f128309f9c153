// The words of descriptions' kinds, as the scene language has them where it has one.
#pragma once

#include "parser/descriptions/pattern.h"
#include "parser/descriptions/scene.h"

namespace lentray::parser {

const char* name_of(CameraKind kind);
const char* name_of(LightKind kind);
const char* name_of(PatternKind kind);
const char* name_of(WaveForm form);
const char* name_of(WarpDesc::Kind kind);
const char* name_of(ImageDesc::Use use);
const char* name_of(ImageDesc::Decoding decoding);
const char* name_of(CsgOperation operation);
const char* name_of(BlobElement::Kind kind);
const char* name_of(CurveKind kind);

}  // namespace lentray::parser
