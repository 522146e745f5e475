#ifndef PLAYHOUSE_C_POINTCLOUD3D_H
#define PLAYHOUSE_C_POINTCLOUD3D_H

#include "playhouse/c/proxy.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A 3D point cloud, such as that of a lidar with several rings. */
PH_PROXY(pointcloud3d)

/** A point of a cloud, in m in the sensor's frame, and its color: red, green, blue, alpha from 0 to 255. */
typedef struct ph_cloud_point {
  double x, y, z;
  uint8_t color[4];
} ph_cloud_point;

ph_status ph_pointcloud3d_points(ph_pointcloud3d *cloud, const ph_cloud_point **points, size_t *count,
                                 ph_error *error);

#ifdef __cplusplus
}
#endif

#endif /* PLAYHOUSE_C_POINTCLOUD3D_H */
