// SPDX-License-Identifier: Apache-2.0
#ifndef UTSURI_LIB_BASIS
#define UTSURI_LIB_BASIS

/// Two unit vectors that make a right-handed basis with the unit vector n (Duff et al. 2017).
void make_basis(vec3 n, out vec3 tangent, out vec3 bitangent) {
    float s = n.z < 0.0 ? -1.0 : 1.0;
    float a = -1.0 / (s + n.z);
    float b = n.x * n.y * a;
    tangent = vec3(1.0 + s * n.x * n.x * a, s * b, -s * n.x);
    bitangent = vec3(b, s + n.y * n.y * a, -n.y);
}

#endif
