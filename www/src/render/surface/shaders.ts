/**
 * The surface's one shader: light, normals, curvature and stripes, with iso-lines and the tint of what a drag changes.
 */

export const vertexShader = /* glsl */ `
attribute vec2 parameter;
attribute float curvature;
varying vec3 vNormal;
varying vec3 vWorld;
varying vec3 vView;
varying vec2 vParameter;
varying float vCurvature;

void main() {
  vNormal = normal;
  vWorld = position;
  vParameter = parameter;
  vCurvature = curvature;
  vec4 seen = modelViewMatrix * vec4(position, 1.0);
  vView = seen.xyz;
  gl_Position = projectionMatrix * seen;
}
`;

export const fragmentShader = /* glsl */ `
uniform int shade;
uniform bool iso;
uniform vec3 front;
uniform vec3 back;
uniform vec3 paper;
uniform vec3 ink;
uniform vec3 tint;
uniform vec3 cool;
uniform vec3 warm;
uniform vec3 eye;
uniform float curvatureScale;
uniform float isoStep;
uniform vec2 period;
uniform vec4 region[8];
uniform int regions;
varying vec3 vNormal;
varying vec3 vWorld;
varying vec3 vView;
varying vec2 vParameter;
varying float vCurvature;

float lineAt(float value) {
  float away = abs(fract(value - 0.5) - 0.5);
  float width = fwidth(value);
  return 1.0 - smoothstep(0.35, 1.25, away / max(width, 1e-6));
}

bool within(float value, float from, float size, float period) {
  if (period <= 0.0) return value >= from && value <= from + size;
  return mod(value - from, period) <= size;
}

void main() {
  vec3 normal = normalize(vNormal);
  vec3 toEye = normalize(eye - vWorld);
  // Along the outline a pixel is shaded a little beyond the edge: what is seen there is still the near side.
  bool away = dot(normal, toEye) < -0.06;
  if (away) normal = -normal;
  vec3 base = away ? back : front;

  // A soft key light over the shoulder, sky from above, and a rim so that the outline holds on the paper.
  vec3 side = normalize(cross(vec3(0.0, 0.0, 1.0), toEye) + vec3(1e-4));
  vec3 key = normalize(toEye + 0.55 * side + vec3(0.0, 0.0, 0.75));
  float diffuse = max(dot(normal, key), 0.0);
  float sky = 0.5 + 0.5 * normal.z;
  float shine = pow(max(dot(normal, normalize(key + toEye)), 0.0), 48.0);
  float rim = pow(1.0 - max(dot(normal, toEye), 0.0), 3.0);
  float light = 0.42 + 0.46 * diffuse + 0.14 * sky;
  vec3 color = base * light + vec3(0.16 * shine) - 0.10 * rim;

  if (shade == 1) color = paper;
  if (shade == 2) color = 0.5 + 0.5 * normal;
  if (shade == 3) {
    float bent = clamp(vCurvature * curvatureScale, -1.0, 1.0);
    vec3 scale = bent < 0.0 ? mix(base * 0.0 + vec3(0.93), cool, sqrt(-bent)) : mix(vec3(0.93), warm, sqrt(bent));
    color = scale * (0.55 + 0.45 * light);
  }
  if (shade == 4) {
    vec3 mirrored = reflect(-toEye, normal);
    float stripe = sin(22.0 * mirrored.z + 3.0 * mirrored.x);
    float edge = clamp(stripe / max(fwidth(stripe), 1e-5), -1.0, 1.0) * 0.5 + 0.5;
    color = mix(vec3(0.12), vec3(0.97), edge) * (0.72 + 0.28 * light);
  }

  for (int i = 0; i < 8; i++) {
    if (i >= regions) break;
    if (within(vParameter.x, region[i].x, region[i].y, period.x) && within(vParameter.y, region[i].z, region[i].w, period.y)) {
      color = mix(color, tint, 0.2);
      break;
    }
  }
  if (iso || shade == 1) {
    float line = max(lineAt(vParameter.x * isoStep), lineAt(vParameter.y * isoStep));
    // Where nothing shades the surface, its outline is drawn as well.
    float outline = shade == 1 ? smoothstep(0.8, 0.97, 1.0 - max(dot(normal, toEye), 0.0)) : 0.0;
    color = mix(color, ink, max(0.8 * outline, line * (shade == 1 ? (away ? 0.35 : 0.85) : 0.34)));
  }
  gl_FragColor = vec4(color, 1.0);
}
`;
