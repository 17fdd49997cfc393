/** What the depth buffer holds at this z of the camera's space. */
const depthOf = Fn(([z], { renderer, camera }) => {
    if (renderer.logarithmicDepthBuffer && !camera.isOrthographicCamera) return viewZToLogarithmicDepth(z, cameraNear, cameraFar);
    const clip = cameraProjectionMatrix.mul(vec4(0, 0, z, 1));
    return clip.z.div(clip.w).clamp(0, 1);
});
