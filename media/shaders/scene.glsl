// SPDX-License-Identifier: BSD-2-Clause
// What all surfaces of the scene share: light, shadow, haze and the curve from linear light to the screen.

uniform vec4 sun_direction;   // Towards the sun.
uniform vec4 sun_colour;      // a: 1 if it casts shadows.
uniform vec4 ambient_colour;
uniform vec4 camera_place;
uniform vec4 haze;            // x: density per metre, y: level of the sky's blur, z: how many further lights.
uniform vec4 sky_mean;        // Light from the sky above, on average.
uniform vec4 haze_colour;     // Light over the horizon, on average.
uniform vec4 light_place[4];  // Further lights; w: 1 a point, 0 a direction (towards the light).
uniform vec4 light_colour[4]; // a: range in metres, 0 unlimited.
uniform vec4 light_fade[4];   // Constant, linear, quadratic.
uniform mat4 sky_turn;        // World to sky.

uniform sampler2D paint;
uniform sampler2DShadow shadow_near;
uniform sampler2DShadow shadow_far;
uniform samplerCube sky;

in vec3 world_position;
in vec3 world_normal;
in vec2 texture_place;
in vec4 paint_values;         // Tint, light, gloss.
in vec4 shadow_place_near;
in vec4 shadow_place_far;

out vec4 fragment;

#ifdef LOW_DETAIL
vec3 ToLinear(vec3 colour) { return colour * colour; }
vec3 FromLinear(vec3 light) { return sqrt(light); }
#else
vec3 ToLinear(vec3 colour) { return pow(colour, vec3(2.2)); }
vec3 FromLinear(vec3 light) { return pow(light, vec3(1.0 / 2.2)); }
#endif

vec3 ToScreen(vec3 light)
{
    // A filmic shoulder that keeps mid tones where they are.
    vec3 x = light * 0.92;
    vec3 curved = (x * (2.51 * x + 0.03)) / (x * (2.43 * x + 0.59) + 0.14);
    return FromLinear(clamp(curved, 0.0, 1.0));
}

vec3 SkyAt(vec3 direction, float blur)
{
    return ToLinear(textureLod(sky, mat3(sky_turn) * direction * vec3(1.0, 1.0, -1.0), blur).rgb);
}

float Lit(sampler2DShadow map, vec3 place, float texel, float spread, float bias)
{
    const vec2 kTaps[8] = vec2[8](vec2(-0.33, -0.88), vec2(0.62, -0.69), vec2(-0.93, -0.21), vec2(0.14, -0.25),
                                  vec2(0.93, 0.18), vec2(-0.44, 0.35), vec2(0.36, 0.62), vec2(-0.32, 0.93));
    const int kCount = 8;
    float lit = 0.0;
    for (int i = 0; i < kCount; ++i)
        lit += texture(map, vec3(place.xy + kTaps[i] * texel * spread, place.z - bias));
    return lit / float(kCount);
}

// 1 in the sun, 0 in shadow: a fine map near the camera, a coarse one further out, none beyond.
float SunLit()
{
#ifdef LOW_DETAIL
    // One map that covers what both do else, but for what is far away.
    vec3 place = vec3(shadow_place_near.xy, shadow_place_near.z * 0.5 + 0.5);
    vec2 edge = abs(place.xy - 0.5);
    float inside = sun_colour.a * clamp((0.49 - max(edge.x, edge.y)) * 12.0, 0.0, 1.0);
    return 1.0 - inside * (1.0 - texture(shadow_near, vec3(place.xy, place.z - 0.0005)));
#else
    vec3 near_place = vec3(shadow_place_near.xy, shadow_place_near.z * 0.5 + 0.5);
    vec3 far_place = vec3(shadow_place_far.xy, shadow_place_far.z * 0.5 + 0.5);
    vec2 near_edge = abs(near_place.xy - 0.5);
    vec2 far_edge = abs(far_place.xy - 0.5);
    float in_near = 1.0 - smoothstep(0.42, 0.49, max(near_edge.x, near_edge.y));
    float in_far = 1.0 - smoothstep(0.40, 0.49, max(far_edge.x, far_edge.y));
    float texel = 1.0 / float(textureSize(shadow_near, 0).x);
    float lit = 1.0;
    if (in_near < 1.0 && in_far > 0.0)
        lit = mix(1.0, Lit(shadow_far, far_place, texel, 1.3, 0.0006), in_far);
    if (in_near > 0.0)
        lit = mix(lit, Lit(shadow_near, near_place, texel, 2.2, 0.0004), in_near);
    return mix(1.0, lit, sun_colour.a);
#endif
}

// How much of the light on its way is lost in the haze.
float Hazed(float distance_m)
{
    float way = distance_m * haze.x;
    float thick = way * sqrt(way);
#ifdef LOW_DETAIL
    return 1.0 - 1.0 / (1.0 + thick * (1.0 + thick * (0.5 + 0.17 * thick)));
#else
    return 1.0 - exp(-thick);
#endif
}

// Costs much where the processor draws, even if there are none: only scenes that have such lights use programs with it.
#ifdef FURTHER_LIGHTS
vec3 FurtherLight(vec3 albedo, vec3 normal)
{
    vec3 light = vec3(0.0);
    int further_lights = int(haze.z + 0.5);
    for (int i = 0; i < further_lights; ++i) {
        vec3 to_light = light_place[i].w > 0.5 ? light_place[i].xyz - world_position : light_place[i].xyz;
        float away = length(to_light);
        if (light_place[i].w > 0.5 && light_colour[i].a > 0.0 && away > light_colour[i].a) continue;
        float fade = light_place[i].w > 0.5
            ? 1.0 / max(dot(light_fade[i].xyz, vec3(1.0, away, away * away)), 1e-3) : 1.0;
        light += albedo * light_colour[i].rgb * max(dot(normal, to_light / max(away, 1e-4)), 0.0) * fade;
    }
    return light;
}
#else
vec3 FurtherLight(vec3 albedo, vec3 normal) { return vec3(0.0); }
#endif

// Light on dull ground, for slow renderers: sun, shadow, sky and haze, no shine, no mirrored sky.
vec3 ShadeDull(vec3 albedo, vec3 normal)
{
    float facing = max(dot(normal, sun_direction.xyz), 0.0);
    vec3 around = ambient_colour.rgb * (sky_mean.rgb * 0.55 + 0.45) * 1.25;
    vec3 light = albedo * (around + sun_colour.rgb * (facing * SunLit() * 0.95)) + haze_colour.rgb * 0.012;
    light += FurtherLight(albedo, normal);
    return mix(light, haze_colour.rgb, Hazed(length(camera_place.xyz - world_position)));
}

// The light that leaves a surface towards the camera, haze included.
vec3 Shade(vec3 albedo, vec3 normal, float gloss, float occlusion)
{
    vec3 to_camera = camera_place.xyz - world_position;
    float distance_m = length(to_camera);
    vec3 view = to_camera / max(distance_m, 1e-4);
    vec3 sun = sun_direction.xyz;
    float facing = dot(normal, sun);
    float lit = facing > 0.0 ? SunLit() : 0.0;

    vec3 from_above = sky_mean.rgb * 0.55 + 0.45;
    vec3 from_below = vec3(0.46, 0.42, 0.37);
    vec3 around = ambient_colour.rgb * mix(from_below, from_above, normal.y * 0.5 + 0.5) * 1.25;
    vec3 light = albedo * (around * occlusion + sun_colour.rgb * max(facing, 0.0) * lit * 0.95);

    float power = mix(14.0, 180.0, gloss);
    vec3 halfway = normalize(sun + view);
    float grazing = 1.0 - max(dot(normal, view), 0.0);
    float fresnel = grazing * grazing * grazing * grazing * grazing;
    float shine = pow(max(dot(normal, halfway), 0.0), power) * mix(0.05, 0.9, gloss) * lit;
    light += sun_colour.rgb * shine;
#ifdef LOW_DETAIL
    vec3 mirrored = mix(from_below * 0.5, haze_colour.rgb, clamp(reflect(-view, normal).y * 2.0 + 0.5, 0.0, 1.0));
#else
    vec3 mirrored = SkyAt(reflect(-view, normal), mix(6.0, 2.0, gloss));
#endif
    light += mirrored * (0.03 + 0.97 * fresnel) * mix(0.06, 0.5, gloss) * occlusion;

    light += FurtherLight(albedo, normal);
    float hazed = Hazed(distance_m);
#ifdef LOW_DETAIL
    vec3 beyond = haze_colour.rgb;
#else
    vec3 beyond = SkyAt(normalize(vec3(-view.x, max(-view.y, 0.015), -view.z)), haze.y);
#endif
    return mix(light, beyond, hazed);
}
