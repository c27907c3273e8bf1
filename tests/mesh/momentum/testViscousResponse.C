// SPDX-License-Identifier: GPL-3.0-or-later

#include "viscousResponse.H"
#include "../../unit/bodies/rigidSamples.H"
#include "../../unit/samples/solidMeshes.H"
#include "../../unit/samples/newShapeTemplate.H"

#include <gtest/gtest.h>

using namespace rigidSamples;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

typedef fsi::viscousResponse::copyLink copyLink;

const scalar dt = 5e-3;

//- Copies of a shape on their way, their response made
autoPtr<bodyGroup> moving(const shapeTemplate& shape, const label nCopies)
{
    autoPtr<bodyGroup> group(bodyGroup::New(shape, dictionary()));
    const label nDims = shape.nDims();
    const vector spin(nDims == 2 ? vector(0, 0, 3) : vector(1, 2, 3));
    for (label i = 0; i < nCopies; ++i)
    {
        group->append(point(i, 0, 0), tensor::I, vector(1, i, 0), spin, i);
    }
    Eigen::MatrixXd v;
    const Eigen::MatrixXd force
    (
        Eigen::MatrixXd::Random(shape.nNodes(), nDims*nCopies)
    );
    for (label i = 0; i < 3; ++i)
    {
        group->predict(0, dt, force, v);
        group->move(dt, v);
    }
    group->prepareResponse(dt);
    return group;
}


//- Links at faces and at single nodes
std::vector<copyLink> someLinks(const shapeTemplate& shape, const label copyi)
{
    std::vector<copyLink> links;
    const label n = shape.nDims();
    forAll(shape.faces(), facei)
    {
        copyLink link;
        link.nodes = -1;
        link.weights = 0.0;
        for (label i = 0; i < n; ++i)
        {
            link.nodes[i] = shape.faces()[facei][i];
            link.weights[i] = (1.0 + i)/(0.5*n*(n + 1));
        }
        link.coefficient = 250*(1 + (facei + copyi) % 3);
        links.push_back(link);
    }
    return links;
}


//- Values of a copy's boundary nodes, component after component
Eigen::VectorXd stacked
(
    const Eigen::MatrixXd& values,
    const shapeTemplate& shape,
    const label copyi
)
{
    const Eigen::MatrixXd own
    (
        values.middleCols(shape.nDims()*copyi, shape.nDims())
       .topRows(shape.nBoundaryNodes())
    );
    return Eigen::Map<const Eigen::VectorXd>(own.data(), own.size());
}


//- C of the boundary nodes of a copy, without the volume's mode
Eigen::MatrixXd compliance(const bodyGroup& group, const label copyi)
{
    const shapeTemplate& shape = group.shape();
    const label n = shape.nDims()*shape.nBoundaryNodes();
    Eigen::MatrixXd C(n, n), v;
    for (label j = 0; j < n; ++j)
    {
        Eigen::MatrixXd force(0*group.positions());
        force
        (
            j % shape.nBoundaryNodes(),
            shape.nDims()*copyi + j/shape.nBoundaryNodes()
        ) = 1;
        group.response().respond(force, v);
        C.col(j) = stacked(v, shape, copyi)/dt;
    }
    for (const auto* m :
        group.response().modesOf(bodyResponse::modeKind::volume))
    {
        const Eigen::VectorXd mode(stacked(m->values, shape, copyi));
        C -= m->sign*mode*mode.transpose();
    }
    return C;
}


//- W + T T^T of a copy
Eigen::MatrixXd resistance
(
    const shapeTemplate& shape,
    const label copyi,
    const std::vector<copyLink>& links,
    const std::vector<Eigen::MatrixXd>& resisting
)
{
    const label nDims = shape.nDims(), nB = shape.nBoundaryNodes();
    Eigen::MatrixXd W(Eigen::MatrixXd::Zero(nDims*nB, nDims*nB));
    for (const copyLink& link : links)
    {
        for (label k = 0; k < nDims*link.nNodes()*link.nNodes(); ++k)
        {
            const label d = k % nDims;
            const label i = (k/nDims) % link.nNodes();
            const label j = k/(nDims*link.nNodes());
            W(d*nB + link.nodes[i], d*nB + link.nodes[j]) +=
                link.coefficient*link.weights[i]*link.weights[j];
        }
    }
    for (const Eigen::MatrixXd& mode : resisting)
    {
        const Eigen::VectorXd t(stacked(mode, shape, copyi));
        W += t*t.transpose();
    }
    return W;
}


//- Compare with the dense solution of v + dt C (W + T T^T) v = v~ + dt C f
void expectDense(const shapeTemplate& shape, const label nCopies)
{
    const auto group = moving(shape, nCopies);
    const label nDims = shape.nDims(), nB = shape.nBoundaryNodes();
    std::vector<std::vector<copyLink>> links;
    for (label i = 0; i < nCopies; ++i)
    {
        links.push_back(someLinks(shape, i));
    }
    std::vector<Eigen::MatrixXd> resisting;
    for (label k = 0; k < (nDims == 2 ? 1 : 3); ++k)
    {
        resisting.push_back(Eigen::MatrixXd::Random(nB, nDims*nCopies));
    }
    const Eigen::MatrixXd predicted
    (
        Eigen::MatrixXd::Random(shape.nNodes(), nDims*nCopies)
    );
    const Eigen::MatrixXd f
    (
        100*Eigen::MatrixXd::Random(nB, nDims*nCopies)
    );

    const auto response = fsi::viscousResponse::New(*group);
    response->update(dt, links.data(), resisting, predicted);
    Eigen::MatrixXd v;
    response->solve(f, v);
    ASSERT_EQ(v.rows(), nB);
    for (label copyi = 0; copyi < nCopies; ++copyi)
    {
        const Eigen::MatrixXd W
        (
            resistance(shape, copyi, links[copyi], resisting)
        );
        const Eigen::MatrixXd C(compliance(*group, copyi));
        const Eigen::MatrixXd all
        (
            Eigen::MatrixXd::Identity(C.rows(), C.rows()) + dt*C*W
        );
        const Eigen::VectorXd expected
        (
            all.partialPivLu().solve
            (
                stacked(predicted, shape, copyi)
              + dt*C*stacked(f, shape, copyi)
            )
        );
        const Eigen::VectorXd start(stacked(predicted, shape, copyi));
        EXPECT_GT((expected - start).norm(), 0.01*start.norm());
        EXPECT_LT
        (
            (stacked(v, shape, copyi) - expected).norm(),
            1e-9*expected.norm()
        );
    }
}


//- A shape of a given type of material
std::unique_ptr<shapeTemplate> disc(const string& material)
{
    return newShapeTemplate
    (
        "disc",
        dictionaryOf
        (
            "shape { type circle; radius 0.1; } material { " + material + " }"
        ),
        0.03,
        1.0,
        2
    );
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(viscousResponse, ofRigidBodiesIsThatOfADenseMatrix)
{
    const vector size(0.3, 0.2, 0.1);
    for (const direction nDims : {2, 3})
    {
        expectDense(*rigidShape(blockSurface(size, nDims), nDims), 2);
    }
    expectDense(*disc("type rigid; density 1000;"), 3);
}


TEST(viscousResponse, ofElasticBodiesIsThatOfADenseMatrix)
{
    expectDense(*disc("density 1000; E 1e4;"), 3);
}


TEST(viscousResponse, ofSolidBodiesIsThatOfADenseMatrix)
{
    const shapeMesh mesh(solidSamples::unevenCube(3, 0.02));
    expectDense
    (
        *rigidShape(mesh, 3, "type neoHookean; density 1000; E 1e4;"), 2
    );
}


// ************************************************************************* //
